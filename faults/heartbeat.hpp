// The watchdog's food is earned (H-25): by all who must work, since the last time, in time, and not too early.
//
// Goals: whatever part of the program stands still, the watchdog bites; so it does when the loop turns without time
// going on.
// Assumptions: each beat is reported by the code that has just done the work, never on behalf of another; take() is
// asked every 2 ms, and is the only thing that leads to feeding.
// Invariants: one missing beat is enough; beats are spent by feeding.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"
#include "faults/set.hpp"

namespace faults {

enum class Beat : uint8_t {
  receive,    // the receiver's characters were taken, and none is left behind
  tick,       // the millisecond clock went on
  step,       // the core did a millisecond's work; it may put it off while the bus comes first, never for long
  output,     // motors, brakes, bridge and relay were written to the pins
  self_test,  // the slow one: the next piece of the chip itself was looked at
};
using Beats = Set<Beat, uint8_t>;

class Heartbeat {
 public:
  // Between two feedings, in microseconds: less than 2 ms, since no pass comes exactly with its tick.
  static constexpr uint16_t shortest = 1500;
  // So many feedings are worth one self_test, which comes every 10 ms.
  static constexpr uint8_t lasting = 10;

  void report(Beats beats) {
    beats_ = beats_ | beats;
    if (beats.has(Beat::self_test)) {
      left_ = lasting;
    }
  }

  // Whether the watchdog may be fed. `now` is of the second clock, which the tick does not depend on.
  bool take(base::Stamp now) {
    constexpr Beats quick =
        Beats::of(Beat::receive) | Beats::of(Beat::tick) | Beats::of(Beat::step) | Beats::of(Beat::output);
    if ((beats_ & quick) != quick || left_ == 0 || (now - fed_at_).count() < shortest) {
      return false;
    }
    beats_ = Beats();
    --left_;
    fed_at_ = now;
    return true;
  }

 private:
  Beats beats_;  // since the last feeding
  uint8_t left_ = 0;
  base::Stamp fed_at_;
};

}  // namespace faults
