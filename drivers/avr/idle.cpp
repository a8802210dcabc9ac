#include "drivers/idle.hpp"

#include <avr/interrupt.h>
#include <avr/sleep.h>

#include "drivers/avr/loop_call.hpp"

namespace drivers {
namespace idle {

void wait() {
  SMCR = 0;  // idle: everything but the CPU goes on
  for (;;) {
    cli();
    if (avr::is_loop_called()) {
      break;
    }
    sleep_enable();
    sei();  // no interrupt is served between this and the next instruction: none is slept through
    sleep_cpu();
    sleep_disable();
  }
  avr::answer_call();
  sei();
}

void enable_interrupts() {
  sei();
}

}  // namespace idle
}  // namespace drivers
