#include "spm/firmware.hpp"

#include "drivers/clock.hpp"
#include "drivers/upkeep.hpp"
#include "drivers/watchdog.hpp"

namespace spm {

void Firmware::start() {
  board_.start();
  spm_.use(board_.load(storage_));
  last_ = drivers::clock::now();
}

void Firmware::pass() {
  drivers::clock::refresh();
  const base::Instant now = drivers::clock::now();
  const Inputs& in = board_.sense(now);
  const Outputs& outputs = spm_.step(in, now);
  board_.apply(outputs);
  if (!outputs.events.empty()) {
    storage_.note(outputs.events);
  }
  if (now != last_) {  // a new millisecond
    last_ = now;
    storage_.step();
    board_.store(storage_);
    drivers::upkeep::refresh();
    is_second_ = !is_second_;
    if (is_second_) {
      stay_alive(in.stamp);
    }
  }
}

// H-25: the only place where the watchdog is fed.
void Firmware::stay_alive(base::Stamp stamp) {
  heartbeat_.report(board_.take_beats() | spm_.take_beats() | faults::Beats::of(faults::Beat::tick));
  if (heartbeat_.take(stamp)) {
    drivers::watchdog::feed();
  }
}

}  // namespace spm
