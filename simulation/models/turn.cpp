#include "simulation/models/turn.hpp"

#include <cmath>

namespace simulation {

Time CharacterTiming::bits(double count) const {
  return Time(std::llround(count * bit_us * 1000));
}

Time transmit_turn(const std::vector<std::uint8_t>& turn, Time now, const CharacterTiming& timing,
                   const Transmit& transmit) {
  const double bits_of_a_byte = 9.0 + timing.stop_bits;
  double sent = 0;
  Time gaps{};
  for (const std::uint8_t byte : turn) {
    if (transmit) {
      transmit(byte, now + timing.bits(sent) + gaps);
    }
    sent += bits_of_a_byte;
    gaps += timing.gap;
  }
  return now + timing.bits(sent) + gaps - timing.gap;
}

}  // namespace simulation
