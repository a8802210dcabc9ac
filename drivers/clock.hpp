// The two clocks. Milliseconds come from the 1 ms tick (timer 0), microseconds from a free-running
// counter (timer 3), so that each can be checked against the other.
#pragma once

#include "drivers/base/time.hpp"

namespace drivers {
namespace clock {

// Starts both. The loop is woken every millisecond.
void start();

// Wakes the loop half-way between two milliseconds, too, for as long as somebody needs the finer grain (SB-2.15).
void tick_twice(bool is_wanted);

// Writes the registers of the 1 ms tick again, undoing an upset (H-27). Cheap; call it in every pass of the loop, for
// without a tick there is no millisecond.
void refresh();
// Those of the microsecond counter; upkeep.hpp calls it.
void refresh_stamps();

base::Instant now();
base::Stamp stamp();

}  // namespace clock
}  // namespace drivers
