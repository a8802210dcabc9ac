#include "drivers/clock.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/avr/bus_timer.hpp"
#include "drivers/avr/interrupt_lock.hpp"
#include "drivers/avr/loop_call.hpp"

namespace {

volatile uint8_t ticks = 0;  // by the interrupt, modulo 256: the watchdog bites long before that is too few
uint32_t milliseconds = 0;   // by the loop
uint8_t ticks_seen = 0;      // of those, in `milliseconds`

constexpr uint8_t tick_top = F_CPU / 64 / 1000 - 1;
static_assert(F_CPU == 64UL * 1000 * (tick_top + 1), "timer 0 makes exactly 1 ms");

}  // namespace

ISR(TIMER0_COMPA_vect) {
  ticks = static_cast<uint8_t>(ticks + 1);
  drivers::avr::call_loop();
}

// Half-way between two ticks. One instruction that touches no flag, so nothing needs to be saved.
ISR(TIMER0_COMPB_vect, ISR_NAKED) {
  drivers::avr::call_loop();
  reti();
}

namespace drivers {
namespace clock {

void start() {
  TCCR0A = _BV(WGM01);  // CTC
  OCR0A = tick_top;
  TCCR0B = _BV(CS01) | _BV(CS00);  // /64
  OCR0B = tick_top / 2;
  TIMSK0 = _BV(OCIE0A);

  TCCR3A = 0;            // free running
  TCCR3B = _BV(CS31);    // /8 = 1 us
  TIMSK3 = _BV(OCIE3A);  // drivers/avr/bus_timer.hpp
}

void tick_twice(bool is_wanted) {
  TIMSK0 = is_wanted ? _BV(OCIE0A) | _BV(OCIE0B) : _BV(OCIE0A);
}

base::Instant now() {
  const uint8_t now = ticks;
  if (now != ticks_seen) {
    milliseconds += static_cast<uint8_t>(now - ticks_seen);
    ticks_seen = now;
  }
  return base::Instant(milliseconds);
}

base::Stamp stamp() {
  avr::InterruptLock lock;  // the two bytes of TCNT3 share a latch with the interrupts' accesses
  return base::Stamp(TCNT3);
}

}  // namespace clock
}  // namespace drivers
