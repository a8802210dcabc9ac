// Where avr-gcc's checks for overflow, bad shifts and bad indices end, in the tests' second image only.
#if defined(PILOTFISH_OVERFLOW_TRAPS)

#include <avr/io.h>

// Written to no RAM, so that the simulated chip stops and says where.
extern "C" void abort() {
  for (;;) {
    *reinterpret_cast<volatile uint8_t*>(RAMEND + 1U) = 0;
  }
}

#endif
