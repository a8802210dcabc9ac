#include "drivers/power_latch.hpp"

#include "drivers/avr/board_spm.hpp"
#include "drivers/base/grant.hpp"

// SB-1.2: the first output after reset. Runs before the loader clears and fills RAM, which takes its time.
extern "C" void hold_power_latch() __attribute__((naked, used, section(".init3")));
extern "C" void hold_power_latch() {
  drivers::avr::PowerLatch::set();
  drivers::avr::PowerLatch::make_output();
}

namespace drivers {
namespace power_latch {

namespace {
base::Grant may_go;  // no flipped bit lets go (H-14, H-27)
}

void hold() {
  may_go.withhold();
  refresh();
}

void release() {
  may_go.give();
  refresh();
}

void refresh() {
  avr::PowerLatch::write(!may_go.is_given());
  avr::PowerLatch::make_output();
}

}  // namespace power_latch
}  // namespace drivers
