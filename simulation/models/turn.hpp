// How remote and attendant control put a turn on the wire: one after the other, by their own clock.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "simulation/time.hpp"

namespace simulation {

// A byte whose start bit begins at `start`, now or later: a whole turn is handed over at once.
using Transmit = std::function<void(std::uint8_t value, Time start)>;

// The clock of a module's UART, for both directions, and its haste.
struct CharacterTiming {
  double bit_us = 1e6 / 38400;  // microseconds
  int stop_bits = 2;
  Time gap{};  // idle line between the bytes of a turn

  Time bits(double count) const;
};

// From `now` on, to `transmit` if there is one. Returns the end of the last stop bit.
Time transmit_turn(const std::vector<std::uint8_t>& turn, Time now, const CharacterTiming& timing,
                   const Transmit& transmit);

}  // namespace simulation
