#include "drivers/watchdog.hpp"

#include <avr/io.h>
#include <avr/wdt.h>

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
  wdt_enable(WDTO_30MS);
}

void feed() {
  wdt_reset();
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
