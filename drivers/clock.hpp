// The two clocks. Milliseconds come from the 1 ms tick (timer 0), microseconds from a free-running
// counter (timer 3), so that each can be checked against the other.
#pragma once

#include "drivers/base/time.hpp"

namespace drivers {
namespace clock {

// Starts both. Wakes the loop every 500 us, the grain of the bus's 60 ms rule (SB-2.15).
void start();

base::Instant now();
base::Stamp stamp();

}  // namespace clock
}  // namespace drivers
