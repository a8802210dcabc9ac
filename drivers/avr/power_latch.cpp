#include "drivers/power_latch.hpp"

#include "drivers/avr/board_spm.hpp"

// SB-1.2: the first output after reset. Runs before the loader clears and fills RAM, which takes its time.
extern "C" void hold_power_latch() __attribute__((naked, used, section(".init3")));
extern "C" void hold_power_latch() {
  drivers::avr::PowerLatch::set();
  drivers::avr::PowerLatch::make_output();
}

namespace drivers {
namespace power_latch {

void hold() {
  avr::PowerLatch::set();
  avr::PowerLatch::make_output();
}

void release() {
  avr::PowerLatch::clear();
  avr::PowerLatch::make_output();
}

}  // namespace power_latch
}  // namespace drivers
