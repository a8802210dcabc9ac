#include "spm/neutral.hpp"

#include <catch2/catch.hpp>

namespace {

using spm::Neutral;

void observe(Neutral& neutral, bool is_at_rest, int times) {
  for (int i = 0; i < times; ++i) {
    neutral.observe(is_at_rest);
  }
}

TEST_CASE("from power-up on neutral is awaited, and shown", "[SB-01.8][H-02]") {
  const Neutral neutral(5);
  CHECK(neutral.is_awaited());
  CHECK(neutral.is_shown());
  CHECK_FALSE(neutral.is_violated());
}

TEST_CASE("five generals at rest in a row are neutral, four are not", "[SB-01.8][H-02]") {
  Neutral neutral(5);
  observe(neutral, true, 4);
  CHECK(neutral.is_awaited());
  observe(neutral, true, 1);
  CHECK_FALSE(neutral.is_awaited());
  CHECK_FALSE(neutral.is_shown());
}

TEST_CASE("one deflected general starts the five over", "[SB-01.8][H-02][H-06]") {
  Neutral neutral(5);
  observe(neutral, true, 4);
  observe(neutral, false, 1);
  CHECK(neutral.is_violated());
  observe(neutral, true, 4);
  CHECK(neutral.is_awaited());
  CHECK_FALSE(neutral.is_violated());
  observe(neutral, true, 1);
  CHECK_FALSE(neutral.is_awaited());
}

TEST_CASE("once neutral was seen the stick may move", "[SB-01.8]") {
  Neutral neutral(5);
  observe(neutral, true, 1000);
  observe(neutral, false, 1000);
  CHECK_FALSE(neutral.is_awaited());
  CHECK_FALSE(neutral.is_violated());
}

TEST_CASE("what forbids driving makes neutral awaited anew, and rest before it does not count", "[SB-01.8][H-02]") {
  Neutral neutral(5);
  observe(neutral, true, 100);
  neutral.require(true);
  CHECK(neutral.is_awaited());
  CHECK(neutral.is_shown());
  observe(neutral, true, 4);
  neutral.require(true);
  observe(neutral, true, 4);
  CHECK(neutral.is_awaited());
  observe(neutral, true, 1);
  CHECK_FALSE(neutral.is_awaited());
}

TEST_CASE("a cause that is not told shows only while the stick is held", "[SB-01.3][SB-01.8]") {
  Neutral neutral(5);
  observe(neutral, true, 5);
  neutral.require(false);
  CHECK(neutral.is_awaited());
  CHECK_FALSE(neutral.is_shown());
  neutral.observe(false);
  CHECK(neutral.is_shown());
  neutral.observe(true);
  CHECK_FALSE(neutral.is_shown());
}

TEST_CASE("a cause that is told stays told when another follows", "[SB-01.3]") {
  Neutral neutral(5);
  observe(neutral, true, 5);
  neutral.require(true);
  neutral.require(false);
  CHECK(neutral.is_shown());
}

}  // namespace
