#include "spm/speech_watch.hpp"

#include <catch2/catch.hpp>

#include "spm/spm.hpp"

namespace spm {
namespace {

using base::Instant;

// Steps a module every millisecond; in.stamp follows unless the test says otherwise.
struct Module {
  const Outputs& step() {
    ++now;
    in.stamp = base::Stamp(static_cast<std::uint16_t>(in.stamp.count() + stamp_step));
    return spm.step(in, Instant(now));
  }
  int events(EventCode code) const {
    int count = 0;
    for (std::uint8_t back = 0; back < faults::EventRing::capacity; ++back) {
      count += spm.events().newest(back).code == static_cast<std::uint8_t>(code) ? 1 : 0;
    }
    return count;
  }
  Inputs in;
  Spm spm;
  std::uint32_t now = 1000;
  unsigned stamp_step = 1000;
};

}  // namespace

TEST_CASE("a transmitter that speaks for 8 ms is hung, one that speaks for the longest turn is not", "[H-30]") {
  SpeechWatch watch;
  std::uint32_t now = 4294967200U;
  for (int turn = 0; turn < 20; ++turn) {
    for (int i = 0; i < 8; ++i) {
      REQUIRE_FALSE(watch.is_hung(Speaker::speaking, Instant(now++)));
    }
    for (int i = 0; i < 13; ++i) {
      REQUIRE_FALSE(watch.is_hung(i < 4 ? Speaker::armed : Speaker::idle, Instant(now++)));
    }
  }
  for (int i = 0; i < 8; ++i) {
    REQUIRE_FALSE(watch.is_hung(Speaker::speaking, Instant(now++)));
  }
  CHECK(watch.is_hung(Speaker::speaking, Instant(now++)));
  CHECK_FALSE(watch.is_hung(Speaker::speaking, Instant(now++)));  // it has been told; 8 ms later it is again
}

TEST_CASE("a hung transmitter is cut off within 10 ms, and an event says so", "[H-30]") {
  Module module;
  for (int i = 0; i < 100; ++i) {
    REQUIRE(module.step().speech != Speech::cut);
  }
  CHECK(module.events(EventCode::transmitter_hung) == 0);
  module.in.speaker = Speaker::speaking;
  int steps = 1;
  while (module.step().speech != Speech::cut) {
    REQUIRE(++steps <= 10);
  }
  CHECK(steps == 9);
  CHECK(module.events(EventCode::transmitter_hung) == 1);
  module.in.speaker = Speaker::idle;
  CHECK(module.step().speech == Speech::as_it_is);
  CHECK_FALSE(module.spm.faults().must_stop);
}

TEST_CASE("clocks that differ are a fault that stays, with an event of its own", "[H-24]") {
  const unsigned stamp_step = GENERATE(0U, 500U, 950U, 1050U, 2000U, 8000U);
  Module module;
  for (int i = 0; i < 1000; ++i) {
    module.step();
  }
  CHECK_FALSE(module.spm.active_faults().has(Fault::internal));
  module.stamp_step = stamp_step;
  int taken = 0;
  while (!module.spm.active_faults().has(Fault::internal)) {
    module.step();
    REQUIRE(++taken <= 120);
  }
  CHECK(module.spm.faults().must_stop);
  module.stamp_step = 1000;
  for (int i = 0; i < 1000; ++i) {
    module.step();
  }
  CHECK(module.spm.faults().must_stop);
  CHECK(module.events(EventCode::clock_differs) == 1);
}

TEST_CASE("every millisecond's work beats; that of others the core does not report", "[H-25]") {
  Module module;
  module.step();
  module.spm.take_beats();
  for (int i = 0; i < 100; ++i) {
    module.step();
    const faults::Beats beats = module.spm.take_beats();
    REQUIRE(beats.has(faults::Beat::step));
    REQUIRE_FALSE(beats.has(faults::Beat::output));     // the board's
    REQUIRE_FALSE(beats.has(faults::Beat::self_test));  // likewise
  }
  module.spm.step(module.in, Instant(module.now));  // no new millisecond
  CHECK(module.spm.take_beats().empty());
}

}  // namespace spm
