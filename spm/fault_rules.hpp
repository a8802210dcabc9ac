// The power module's faults, most severe first (SB-01.9).
#pragma once

#include <stdint.h>

#include "faults/manager.hpp"
#include "faults/set.hpp"

namespace spm {

enum class Fault : uint8_t {
  internal,          // our own state made no sense
  self_test,         // H-27: flash or RAM is not what it should be
  restart_loop,      // H-25: too many unexpected starts in a short time
  left_motor,        // H-10
  right_motor,       // H-10
  brake,             // H-13
  unexpected_start,  // SB-3.9
  settings_lost,     // H-20
  corrupt_packets,   // SB-2.14
  general_missing,   // SB-2.15
  remote_restarted,  // SB-3.4
  joystick_error,    // SB-00.6
  remote_fault,      // SB-00.6
  pot_error,         // SB-00.6
  remote_limps,      // SB-00.6
  battery_flat,
  battery_low,     // H-26: slower before it is flat
  over_voltage,    // H-26: braking feeds a full battery
  stalled,         // H-31: too much current for too long
  out_of_neutral,  // SB-01.8
};
constexpr uint8_t fault_count = 20;

using FaultBits = uint32_t;
using FaultSet = faults::Set<Fault, FaultBits>;

extern const faults::Row fault_rows[fault_count];

}  // namespace spm
