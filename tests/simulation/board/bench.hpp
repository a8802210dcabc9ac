// A simulated chip with one of the small test firmwares in tests/firmware, and what a test needs to look at it.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"

namespace simulation {

struct Spoken {
  std::uint8_t value;
  Time start;
  bool operator==(const Spoken&) const = default;
};

struct Bench {
  // `settings` are the first bytes of the EEPROM; the firmwares choose by them what to do.
  explicit Bench(const std::string& firmware, std::vector<std::uint8_t> settings = {0}, std::int32_t clock_error = 0,
                 const std::string& folder = PILOTFISH_TEST_FIRMWARE_DIR, bool watches_locks = false)
      : board(make_avr_board_with_insight(
            {.image = image(firmware, folder), .clock_error_ppm = clock_error, .watches_locks = watches_locks})) {
    board->set_eeprom(settings);
    board->on_speak([this](std::uint8_t value, Time start) { spoken.push_back({value, start}); });
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  static std::string image(const std::string& firmware, const std::string& folder = PILOTFISH_TEST_FIRMWARE_DIR) {
    return folder + "/" + firmware + ".elf";
  }

  Bench& start() {
    board->power(true, now);
    return *this;
  }

  Bench& run(Time span) {
    const Time limit = now + span;
    while (now < limit) {
      now = board->run_until(limit);
    }
    return *this;
  }

  Bench& wake(bool level) {
    surroundings.wake = level;
    board->surround(surroundings);
    return *this;
  }

  void hear(std::uint8_t value, bool framing_error = false) { board->hear({value, framing_error, now}); }

  unsigned byte(const std::string& variable, unsigned index = 0) const {
    const auto address = board->address_of(variable);
    REQUIRE(address.has_value());
    return board->ram(static_cast<std::uint16_t>(*address + index));
  }

  unsigned word(const std::string& variable) const { return byte(variable) | byte(variable, 1) << 8; }

  std::unique_ptr<AvrBoard> board;
  Time now{};
  Surroundings surroundings;
  std::vector<Spoken> spoken;
};

}  // namespace simulation
