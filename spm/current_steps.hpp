// Currents for sums in 16 bits: steps of 64 mA, as the AVR pays for every wider product. 125 A, all that the sensors
// can say, are 1953 of them.
#pragma once

#include <stdint.h>

#include "drivers/base/units.hpp"

namespace spm {

constexpr int16_t most_current_steps = 2047;

constexpr int16_t current_steps_of_size(uint32_t milliamps) {
  return milliamps >= uint32_t{most_current_steps} * 64 ? most_current_steps : static_cast<int16_t>(milliamps >> 6);
}
// Towards zero; what is beyond the scale is its end.
constexpr int16_t current_steps(base::Milliamps current) {
  return current < base::Milliamps(0)
             ? static_cast<int16_t>(-current_steps_of_size(0U - static_cast<uint32_t>(current.count())))
             : current_steps_of_size(static_cast<uint32_t>(current.count()));
}

}  // namespace spm
