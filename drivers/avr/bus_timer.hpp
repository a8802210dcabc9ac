// Timer 3's two compares, the bus's appointments: A wakes the loop when silence on the line means something, B is the
// moment at which a turn begins.
#pragma once

#include <avr/io.h>
#include <stdint.h>

namespace drivers {
namespace avr {

// Runs freely at F_CPU / 8 = 1 us. Interrupts must be off. A turn that has been scheduled stays so.
inline void run_bus_timer() {
  TCCR3A = 0;
  TCCR3B = _BV(CS31);
  TIMSK3 = static_cast<uint8_t>((TIMSK3 & _BV(OCIE3B)) | _BV(OCIE3A));
}

// Interrupts must be off. `at` is a count of timer 3.
inline void schedule_silence(uint16_t at) {
  OCR3A = at;
}

// Interrupts must be off. `delay` in microseconds, at least 4.
inline void schedule_turn(uint16_t delay) {
  OCR3B = static_cast<uint16_t>(TCNT3 + delay);
  TIFR3 = _BV(OCF3B);
  TIMSK3 |= _BV(OCIE3B);
}

inline void cancel_turn() {
  TIMSK3 &= static_cast<uint8_t>(~_BV(OCIE3B));
}

}  // namespace avr
}  // namespace drivers
