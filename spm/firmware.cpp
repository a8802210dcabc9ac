#include "spm/firmware.hpp"

#include "drivers/clock.hpp"
#include "drivers/serial.hpp"
#include "drivers/watchdog.hpp"

namespace spm {

void Firmware::start() {
  board_.start();
  spm_.use(board_.load(storage_));
  last_ = drivers::clock::now();
}

void Firmware::pass() {
  const base::Instant now = drivers::clock::now();
  const Outputs& outputs = spm_.step(board_.sense(now), now);
  board_.apply(outputs);
  if (!outputs.events.empty()) {
    storage_.note(outputs.events);
  }
  if (now != last_) {  // a clock that stands still starves the watchdog, whatever else goes on
    last_ = now;
    storage_.step();
    board_.store(storage_);
    drivers::serial::refresh();
    drivers::watchdog::feed();
  }
}

}  // namespace spm
