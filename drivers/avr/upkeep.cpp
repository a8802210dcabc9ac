#include "drivers/upkeep.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/clock.hpp"
#include "drivers/power_latch.hpp"
#include "drivers/serial.hpp"
#include "drivers/signals.hpp"

namespace {

uint8_t turn;

// What this firmware does not use and what would take pins away: timer 2 those of the directions, SPI the relay's, TWI
// the brakes'; the comparator blinds wake.
void release_pins() {
  TCCR2A = 0;
  SPCR = 0;
  TWCR = 0;
  DIDR1 = 0;
  MCUCR = 0;  // pull-ups work
}

// What else this firmware does not use. Flags are cleared by ones, so zeros do not touch them.
void keep_unused_off() {
  PRR1 = 0;
  ACSR = 0;
  TCCR2B = 0;
  TIMSK1 = 0;
  TIMSK2 = 0;
  UCSR1B = 0;
  PCICR = 0;
  EIMSK = 0;
  SPMCSR = 0;
  EECR &= static_cast<uint8_t>(~_BV(EERIE));  // one instruction
}

void refresh_pins() {
  PORTA = 0;     // no pull-ups
  DIDR0 = 0xFF;  // all of port A is analog
  drivers::signals::refresh();
  drivers::power_latch::refresh();
}

}  // namespace

// Of all interrupts without a handler, which only an upset can have asked for. Left alone, this one would start the
// program anew under way, without a reset.
ISR(BADISR_vect) {
  release_pins();
  keep_unused_off();
}

namespace drivers {
namespace upkeep {

void refresh() {
  ++turn;
  if ((turn & 1U) != 0) {
    release_pins();
    clock::refresh_stamps();
    refresh_pins();
    return;
  }
  serial::refresh();
  if (turn == 0) {
    keep_unused_off();
  }
}

}  // namespace upkeep
}  // namespace drivers
