// What interrupts have cost so far: each one's own time, and how long they were off for all.
#pragma once

#include <cstdint>

namespace simulation {

// From its acceptance to the end of RETI, interrupts nested in it included.
struct InterruptUse {
  std::uint8_t vector = 0;  // as in avr-libc's __vector_N
  std::uint32_t count = 0;
  std::uint64_t cycles = 0;
  std::uint64_t longest = 0;
};

// SREG's I flag was clear, from the end of the instruction that cleared it, or from the acceptance of an interrupt, to
// the end of the instruction that set it.
struct OffSpan {
  std::uint64_t cycles = 0;
  std::uint32_t from = 0;  // address of that instruction, or of that interrupt's vector
};

// The longest spans; all 0 while there was none.
struct InterruptsOff {
  OffSpan by_program;     // outside of any interrupt handler
  OffSpan with_handlers;  // whoever did it
  OffSpan at_start;       // from a reset to the first SEI, which counts for neither of these
};

}  // namespace simulation
