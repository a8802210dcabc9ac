#include "bus/shark/responder.hpp"

#include <catch2/catch.hpp>

#include "bus/shark/codec.hpp"

namespace {

using namespace bus::shark;
using namespace base;

void earn(Responder& responder) {
  responder.open().add(encode(SpmPowerUp()));
  responder.close();
}

TEST_CASE("an earned answer is armed at once, to begin with the next TF", "[SB-2.7]") {
  Responder responder;
  CHECK(responder.speech() == Speech::as_it_is);
  earn(responder);
  CHECK(responder.speech() == Speech::arm);
  CHECK(responder.turn().bytes().size() == 4);
  responder.begin_step();
  CHECK(responder.speech() == Speech::as_it_is);
}

TEST_CASE("a turn that earned nothing ends in silence", "[SB-2.13]") {
  Responder responder;
  CHECK(responder.finish(false, 0_us, 1500_us));
  CHECK(responder.speech() == Speech::as_it_is);
}

TEST_CASE("when the turn has ended and the transmitter did not begin by itself, it is told to speak", "[SB-2.12]") {
  Responder responder;
  earn(responder);
  responder.begin_step();
  CHECK(responder.finish(false, 1500_us, 1500_us));
  CHECK(responder.speech() == Speech::speak);
}

TEST_CASE("a transmitter that already speaks is left alone", "[SB-2.7]") {
  Responder responder;
  earn(responder);
  responder.begin_step();
  CHECK(responder.finish(true, 100_us, 1500_us));
  CHECK(responder.speech() == Speech::as_it_is);
}

TEST_CASE("an answer whose slot has passed is not given", "[SB-2.8][H-30]") {
  Responder responder;
  earn(responder);
  responder.begin_step();
  CHECK_FALSE(responder.finish(false, 1501_us, 1500_us));
  CHECK(responder.speech() == Speech::hush);
}

TEST_CASE("one answer at most for each turn", "[SB-2.9]") {
  Responder responder;
  earn(responder);
  responder.finish(false, 0_us, 1500_us);
  responder.begin_step();
  CHECK(responder.finish(false, 0_us, 1500_us));
  CHECK(responder.speech() == Speech::as_it_is);
}

TEST_CASE("a hushed answer does not come back with the end of the turn", "[SB-1.3]") {
  Responder responder;
  earn(responder);
  responder.hush();
  CHECK(responder.speech() == Speech::hush);
  responder.begin_step();
  CHECK(responder.finish(false, 0_us, 1500_us));
  CHECK(responder.speech() == Speech::as_it_is);
}

}  // namespace
