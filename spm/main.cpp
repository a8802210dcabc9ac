// The image's entry. Long before main() the power latch has been held (SB-1.2, drivers/avr/power_latch.cpp).
#include "drivers/idle.hpp"
#include "spm/firmware.hpp"

namespace {

// Placed and initialised by the loader; the one owner of everything the power module knows.
spm::Firmware firmware;

TURN_OF_THE_LOOP void turn_of_the_loop() {
  firmware.pass();
  drivers::idle::wait();
}

}  // namespace

int main() {
  firmware.start();
  drivers::idle::enable_interrupts();
  for (;;) {
    turn_of_the_loop();
  }
}
