// How fresh the flashed image's analog readings are.
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "simulation/board/avr_board.hpp"

namespace simulation {

TEST_CASE("what driving depends on is measured anew every 5 ms, the other channels every 20, without an interrupt",
          "[H-10][H-13]") {
  constexpr unsigned adc_interrupt = 24;
  constexpr std::array<double, 8> first{0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4};
  constexpr std::array<double, 8> second{4.5, 4.25, 3.75, 3.25, 2.75, 2.25, 1.75, 1.25};
  const auto chip = make_avr_board_with_insight({.image = std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf"});
  const auto results = chip->address_of("_ZN7drivers6analog12_GLOBAL__N_17resultsE");
  REQUIRE(results);
  Time now{};
  const auto run = [&](Time span) {
    for (const Time limit = now + span; now < limit;) {
      now = chip->run_until(limit);
    }
  };
  const auto shows = [&](const std::array<double, 8>& volts, unsigned channel) {
    const auto at = static_cast<std::uint16_t>((*results & 0xFFFFU) + 2 * channel);
    const int raw = chip->ram(at) | chip->ram(static_cast<std::uint16_t>(at + 1)) << 8;
    return raw == static_cast<int>(volts[channel] / 5 * 1024);
  };
  chip->surround({.analog_volts = first});
  chip->power(true, now);
  run(300ms);  // the self-test, and a round of conversions
  for (unsigned channel = 0; channel < 8; ++channel) {
    CAPTURE(channel);
    CHECK(shows(first, channel));
  }
  for (const Time moment : {0us, 1300us, 2600us, 3900us}) {
    run(moment);
    const auto before = shows(first, 0) ? first : second;
    const auto after = before == first ? second : first;
    chip->surround({.analog_volts = after});
    run(6500us);  // 5 ms, the conversion's own, and the loop's
    for (unsigned channel = 0; channel < 4; ++channel) {
      CAPTURE(channel, moment.count());
      CHECK(shows(after, channel));
    }
    int old = 0;
    for (unsigned channel = 4; channel < 8; ++channel) {
      old += shows(before, channel) ? 1 : 0;
    }
    CHECK(old >= 2);
    run(16ms);
    for (unsigned channel = 0; channel < 8; ++channel) {
      CAPTURE(channel, moment.count());
      CHECK(shows(after, channel));
    }
  }
  for (const auto& use : chip->interrupt_use()) {
    CHECK(use.vector != adc_interrupt);
  }
}

}  // namespace simulation
