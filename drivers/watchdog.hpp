// The last resort against a program that no longer runs its loop, and why the chip last started.
#pragma once

#include <stdint.h>

namespace drivers {
namespace watchdog {

enum class ResetCause : uint8_t { power_on, external, brown_out, watchdog, unknown };

// Nominal time-out 30 ms; the oscillator may stretch it to 60.
void start();
// Sets it up again as well: an upset does not switch it off (H-27).
void feed();
// Reads and clears the chip's cause register on first use; the same answer afterwards.
ResetCause reset_cause();

}  // namespace watchdog
}  // namespace drivers
