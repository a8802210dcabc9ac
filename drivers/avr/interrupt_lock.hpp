// Interrupts off for the rest of a scope, then as they were. Keep the scope shorter than 20 us.
#pragma once

#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdint.h>

namespace drivers {
namespace avr {

// For a single byte, which needs no lock: what follows is read anew, whatever the compiler knows of it.
inline void look_again() {
  __asm__ __volatile__("" ::: "memory");
}

class InterruptLock {
 public:
  InterruptLock() : status_(SREG) {
    cli();
    __asm__ __volatile__("" ::: "memory");
  }
  ~InterruptLock() {
    __asm__ __volatile__("" ::: "memory");
    SREG = status_;
  }
  InterruptLock(const InterruptLock&) = delete;
  InterruptLock& operator=(const InterruptLock&) = delete;

 private:
  uint8_t status_;
};

}  // namespace avr
}  // namespace drivers
