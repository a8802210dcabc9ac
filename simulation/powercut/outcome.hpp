// What a cell may hold whose write was cut: anything. Those that a careless layout would take for whole come first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/board/avr_eeprom_write.hpp"

namespace simulation::powercut {

// The same numbers from the same seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U + 1) {}
  std::uint32_t below(std::uint32_t limit);

 private:
  std::uint64_t state_;
};

struct Outcome {
  enum class Kind : std::uint8_t { old, erased, complete, bit_of_old, bit_of_new, random };

  Kind kind = Kind::old;
  std::uint8_t value = 0;  // which bit, or the random byte itself

  std::uint8_t left(const EepromWrite& write) const;
  std::string tell() const;
};

// Old, erased, new, each bit of both, three random bytes.
std::vector<Outcome> all_outcomes(Random& random);
// Old, erased, new, one bit of either, one random byte.
std::vector<Outcome> some_outcomes(Random& random);

}  // namespace simulation::powercut
