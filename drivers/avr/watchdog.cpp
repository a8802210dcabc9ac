#include "drivers/watchdog.hpp"

#include <avr/io.h>
#include <avr/wdt.h>

#include "drivers/avr/interrupt_lock.hpp"

// Why the chip started, saved before anything else: MCUSR must be cleared, or the watchdog cannot be switched
// off and would bite again during start-up.
static uint8_t saved_cause __attribute__((section(".noinit")));

extern "C" void save_reset_cause() __attribute__((naked, used, section(".init3")));
extern "C" void save_reset_cause() {
  saved_cause = MCUSR;
  MCUSR = 0;
  wdt_disable();
}

namespace drivers {
namespace watchdog {

void start() {
  feed();
}

void feed() {
  avr::InterruptLock lock;  // the second write must follow within four cycles
  wdt_reset();
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDE) | _BV(WDP0);  // a reset, and no interrupt, after 4096 cycles of 128 kHz: 32 ms
}

ResetCause reset_cause() {
  if (saved_cause & _BV(WDRF)) {
    return ResetCause::watchdog;
  }
  if (saved_cause & _BV(PORF)) {  // a slow supply sets the brown-out flag as well
    return ResetCause::power_on;
  }
  if (saved_cause & _BV(BORF)) {
    return ResetCause::brown_out;
  }
  return (saved_cause & _BV(EXTRF)) ? ResetCause::external : ResetCause::unknown;
}

}  // namespace watchdog
}  // namespace drivers
