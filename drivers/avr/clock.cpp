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
constexpr uint8_t half_a_tick = tick_top / 2;
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
  refresh();
  OCR0B = half_a_tick;
  TIMSK0 = _BV(OCIE0A);
  avr::run_bus_timer();
}

void refresh() {
  PRR0 = 0;                        // all clocks run
  GTCCR = 0;                       // and their common prescaler
  TCCR0A = _BV(WGM01);             // CTC
  TCCR0B = _BV(CS01) | _BV(CS00);  // /64
  if (OCR0A != tick_top) {
    OCR0A = tick_top;
  }
}

void refresh_stamps() {
  avr::InterruptLock lock;
  avr::run_bus_timer();
}

void tick_twice(bool is_wanted) {
  if (is_wanted) {
    OCR0B = half_a_tick;
  }
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
