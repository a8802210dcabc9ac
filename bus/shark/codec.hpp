// Frames to packets and back. The framer has already checked length, markers and checksum, and a turn will add them;
// here a frame gets its meaning. All functions are pure.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "bus/shark/packets.hpp"

namespace bus {
namespace shark {

enum class Admission : uint8_t {
  known,    // a type that is sent to us with at least its least data; longer is accepted (SB-5.2)
  unknown,  // a reserved type, or one that only we say: discard, not corrupt (SB-5.1)
  corrupt,  // a known type with too little data (SB-5.3)
};

Admission admit(const Frame& frame);

// The frame must be `known` and of the packet's type.
SrGeneral decode_sr_general(const Frame& frame);
HhpData decode_sr_hhp_data(const Frame& frame);
SrPowerUp decode_sr_power_up(const Frame& frame);
JoystickCalibration decode_joystick_calibration(const Frame& frame);
FactoryTest decode_factory_test(const Frame& frame);
SacuGeneral decode_sacu_general(const Frame& frame);
SacuPowerUp decode_sacu_power_up(const Frame& frame);

// Frames of what we say, for a Turn to put on the wire. Values beyond a field's range are cut to it; unused bits are
// zero (SB-5.4).
Frame encode(const SpmGeneral& packet);
Frame encode(const HhpData& packet);
Frame encode(const SpmPowerUp& packet);
Frame encode(const SpmSettings& packet);

}  // namespace shark
}  // namespace bus
