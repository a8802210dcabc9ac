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

namespace {
bool is_held = true;
}

void hold() {
  is_held = true;
  refresh();
}

void release() {
  is_held = false;
  refresh();
}

void refresh() {
  avr::PowerLatch::write(is_held);
  avr::PowerLatch::make_output();
}

}  // namespace power_latch
}  // namespace drivers
