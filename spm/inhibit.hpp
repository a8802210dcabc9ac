// Every reason not to drive, as one set: what the gate obeys, the bus reports and a person can be told.
#pragma once

#include <stdint.h>

#include "faults/set.hpp"

namespace spm {

enum class Inhibit : uint8_t {
  no_general_yet,    // SB-3.1: nothing moves before the power-up phase has ended
  transient,         // SB-2.14 to SB-2.17: communication was lost, or the stop for it is not yet over
  fault,             // a fault that stops the chair: see the fault set
  remote_inhibit,    // SB-00.4
  charger_inhibit,   // SB-00.5
  calibration,       // SB-01.10
  invalid_mode,      // SB-00.7: the requested operating mode may not be entered
  powering_down,     // SB-4.1: the power button, sleep, or the end
  awaiting_neutral,  // SB-01.8: the stick has not been seen at rest since something above
};

using Inhibits = faults::Set<Inhibit>;

}  // namespace spm
