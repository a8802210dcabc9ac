#include "spm/status_led.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace {

using namespace spm;

// How often the LED comes on, and how long it is dark at most, in 10 seconds.
struct Watched {
  int flashes = 0;
  int longest_dark = 0;
  int longest_light = 0;
};

Watched watch(StatusLed& led, std::uint8_t flashes, std::uint32_t from, int milliseconds) {
  Watched seen;
  int dark = 0;
  int light = 0;
  bool was_on = led.is_on();
  for (int i = 0; i < milliseconds; ++i) {
    led.step(flashes, base::Instant(from + static_cast<std::uint32_t>(i)));
    seen.flashes += led.is_on() && !was_on ? 1 : 0;
    was_on = led.is_on();
    dark = was_on ? 0 : dark + 1;
    light = was_on ? light + 1 : 0;
    seen.longest_dark = std::max(seen.longest_dark, dark);
    seen.longest_light = std::max(seen.longest_light, light);
  }
  return seen;
}

TEST_CASE("while all is well the LED is steady") {
  StatusLed led;
  watch(led, 0, 1000, 2000);
  const Watched seen = watch(led, 0, 3000, 10000);
  CHECK(seen.flashes == 0);
  CHECK(seen.longest_dark == 0);
}

TEST_CASE("otherwise it flashes as many times as the system state says, then pauses", "[SB-01.9]") {
  for (std::uint8_t state = 1; state <= 10; ++state) {
    StatusLed led;
    const std::uint32_t from = 0xFFFFFFFF - 3000;  // across the wrap
    watch(led, state, from, 5000);
    // A group is `state` flashes of 0.2 s on and 0.2 s off, and 1.2 s more of darkness.
    const int group = 400 * state + 1200;
    const Watched seen = watch(led, state, from + 5000, group * 3);
    CAPTURE(int(state));
    CHECK(seen.flashes == 3 * state);
    CHECK(seen.longest_dark == 1400);
    CHECK(seen.longest_light == 200);
  }
}

TEST_CASE("when the state changes the LED is soon in step with it") {
  StatusLed led;
  watch(led, 10, 1000, 3300);
  watch(led, 1, 4300, 2000);
  CHECK(watch(led, 1, 6300, 1600 * 3).flashes == 3);
  watch(led, 0, 11100, 500);
  CHECK(watch(led, 0, 11600, 1000).longest_dark == 0);
}

}  // namespace
