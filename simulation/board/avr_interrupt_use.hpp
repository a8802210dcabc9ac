// What one interrupt has cost so far, from its acceptance to RETI, interrupts nested in it included.
#pragma once

#include <cstdint>

namespace simulation {

struct InterruptUse {
  std::uint8_t vector = 0;  // as in avr-libc's __vector_N
  std::uint32_t count = 0;
  std::uint64_t cycles = 0;
  std::uint64_t longest = 0;
};

}  // namespace simulation
