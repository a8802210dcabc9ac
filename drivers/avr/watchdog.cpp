#include "drivers/watchdog.hpp"

#include <avr/io.h>
#include <avr/wdt.h>

#include "drivers/avr/board_spm.hpp"
#include "drivers/avr/interrupt_lock.hpp"

// Why the chip started, saved before anything else: MCUSR must be cleared, or the watchdog cannot be switched
// off and would bite again during start-up. It lives in GPIOR1, because RAM is tested after this. A start that hangs is
// given up after half a second.
extern "C" void save_reset_cause() __attribute__((naked, used, section(".init3")));
extern "C" void save_reset_cause() {
  const uint8_t cause = MCUSR;
  GPIOR1 = cause;
  MCUSR = 0;
  if (cause == 0) {  // H-25: no reset. A program gone astray has come to address 0, its outputs still on
    drivers::avr::BridgeEnable::clear();
    drivers::avr::MotorRelay::clear();
    drivers::avr::LeftBrakeRelease::clear();
    drivers::avr::RightBrakeRelease::clear();
    wdt_enable(WDTO_15MS);
    for (;;) {
    }
  }
  wdt_disable();  // first, because simavr does not see that a running one is given another time
  wdt_enable(WDTO_500MS);
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
  const uint8_t saved_cause = GPIOR1;
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
