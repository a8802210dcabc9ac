#include "spm/firmware.hpp"

#include "drivers/clock.hpp"
#include "drivers/serial.hpp"
#include "drivers/watchdog.hpp"

namespace spm {

void Firmware::start() {
  board_.start();
  spm_.use(board_.settings());
  last_ = drivers::clock::now();
}

void Firmware::pass() {
  const base::Instant now = drivers::clock::now();
  board_.apply(spm_.step(board_.sense(now), now));
  if (now != last_) {  // a clock that stands still starves the watchdog, whatever else goes on
    last_ = now;
    drivers::serial::refresh();
    drivers::watchdog::feed();
  }
}

}  // namespace spm
