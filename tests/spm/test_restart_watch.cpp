#include "spm/restart_watch.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <initializer_list>

namespace {

using spm::RestartWatch;
using spm::Start;
using Bytes = RestartWatch::Bytes;

// A module whose program runs, is reset and runs again; only the four bytes go through the reset.
struct Module {
  void start(Start why) {
    watch = RestartWatch();
    now = base::Instant(0);
    watch.begin(kept, why, now);
    kept = watch.bytes();
  }
  void run(uint32_t milliseconds) {
    for (uint32_t i = 0; i < milliseconds; ++i) {
      now = now + base::Millis(1);
      if (watch.step(now)) {
        kept = watch.bytes();
      }
    }
  }

  RestartWatch watch;
  Bytes kept{{0x12, 0x34, 0x56, 0x78}};  // garbage
  base::Instant now;
};

bool is(const Bytes& bytes, std::initializer_list<int> expected) {
  return std::equal(bytes.begin(), bytes.end(), expected.begin());
}

}  // namespace

TEST_CASE("three unexpected starts within ten seconds are a loop, two are not", "[H-25]") {
  Module module;
  module.start(Start::power_on);
  module.run(1000);
  module.start(Start::watchdog);
  module.run(2000);
  module.start(Start::brown_out);
  CHECK_FALSE(module.watch.is_looping());
  module.run(7000);
  module.start(Start::watchdog);
  CHECK(module.watch.is_looping());
}

// Of the ten seconds the module itself sees all but the time from each reset to its program.
TEST_CASE("the third start counts 10.0 s after the first, and does not 10.3 s after it", "[H-25]") {
  constexpr uint32_t from_reset_to_program = 197;
  for (const uint32_t span : {10000U, 10300U}) {
    Module module;
    module.start(Start::power_on);
    module.start(Start::watchdog);
    module.run(5000 - from_reset_to_program);
    module.start(Start::watchdog);
    module.run(span - 5000 - from_reset_to_program);
    module.start(Start::watchdog);
    CHECK(module.watch.is_looping() == (span == 10000U));
  }
}

TEST_CASE("a loop stays one over every reset, and ends with a power cycle", "[H-25]") {
  Module module;
  module.start(Start::power_on);
  for (int i = 0; i < 3; ++i) {
    module.start(Start::watchdog);
    module.run(100);
  }
  REQUIRE(module.watch.is_looping());
  CHECK(is(module.kept, {0xE1, 0xE1, 0x1E, 0x1E}));
  module.run(60000);
  CHECK(module.watch.is_looping());
  for (const Start why : {Start::external, Start::watchdog, Start::brown_out}) {
    module.start(why);
    CHECK(module.watch.is_looping());
  }
  module.start(Start::power_on);
  CHECK_FALSE(module.watch.is_looping());
  module.start(Start::watchdog);
  module.start(Start::watchdog);
  CHECK_FALSE(module.watch.is_looping());
}

TEST_CASE("a reset by hand neither counts nor loses what was counted", "[H-25]") {
  Module module;
  module.start(Start::power_on);
  module.start(Start::watchdog);
  module.start(Start::external);
  module.start(Start::watchdog);
  module.start(Start::external);
  CHECK_FALSE(module.watch.is_looping());
  module.start(Start::watchdog);
  CHECK(module.watch.is_looping());
}

TEST_CASE("the kept bytes are both ages in 50 ms and their complements", "[H-25]") {
  Module module;
  module.start(Start::power_on);
  CHECK(is(module.kept, {201, 201, 54, 54}));
  module.start(Start::watchdog);
  CHECK(is(module.kept, {3, 201, 252, 54}));
  module.run(1000);
  CHECK(is(module.kept, {23, 201, 232, 54}));
  module.start(Start::watchdog);
  CHECK(is(module.kept, {3, 26, 252, 229}));
  module.run(30000);
  CHECK(is(module.kept, {201, 201, 54, 54}));
}

TEST_CASE("bytes that are not whole count as one restart and no more: neither a loop nor nothing", "[H-25]") {
  // The last of a loop but for one bit, each bit in turn; then all zero, all one, impossible ages.
  for (int bit = 0; bit < 32; ++bit) {
    Module module;
    module.kept = Bytes{{0xE1, 0xE1, 0x1E, 0x1E}};
    module.kept[static_cast<uint8_t>(bit / 8)] ^= static_cast<uint8_t>(1 << bit % 8);
    module.start(Start::brown_out);
    CHECK_FALSE(module.watch.is_looping());
    CHECK(is(module.kept, {3, 3, 252, 252}));
  }
  const Bytes odd[] = {
      {{0, 0, 0, 0}}, {{0xFF, 0xFF, 0xFF, 0xFF}}, {{210, 210, 45, 45}}, {{0xE1, 5, 0x1E, 0xFA}}, {{9, 5, 0xF6, 0xFA}}};
  for (const Bytes& kept : odd) {
    Module module;
    module.kept = kept;
    module.start(Start::watchdog);
    CHECK(is(module.kept, {3, 3, 252, 252}));
  }
}

TEST_CASE("a record that was lost, as in a start that was reset while RAM was tested, counts as one restart",
          "[H-25]") {
  Module module;
  module.start(Start::power_on);
  module.run(1000);
  module.start(Start::brown_out);
  module.run(1000);
  module.kept = Bytes{{0xF0, 0xF0, 0xF0, 0xF0}};  // what the RAM test leaves
  module.start(Start::brown_out);
  CHECK_FALSE(module.watch.is_looping());
  module.run(1000);
  module.start(Start::brown_out);
  CHECK(module.watch.is_looping());
}
