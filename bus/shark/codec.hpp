// Frames to packets and back. The framer has already checked length, markers and checksum; here a frame
// gets its meaning. All functions are pure.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "bus/shark/packets.hpp"
#include "drivers/base/span.hpp"

namespace bus {
namespace shark {

enum class Admission : uint8_t {
  known,    // a type of section 5 with at least its least data; longer is accepted (SB-5.2)
  unknown,  // a reserved type: discard, not corrupt (SB-5.1)
  corrupt,  // a known type with too little data (SB-5.3)
};

Admission admit(const Frame& frame);

// The frame must be `known` and of the packet's type.
SrGeneral decode_sr_general(const Frame& frame);
SrPowerUp decode_sr_power_up(const Frame& frame);

// The complete packet as sent: start byte, data, checksum. Values beyond a field's range are cut to it;
// unused bits are zero (SB-5.4).
class Packet {
 public:
  // Adds start byte, markers and checksum to 1 to 8 data bytes.
  Packet(Type type, base::Span<const uint8_t> data);

  base::Span<const uint8_t> bytes() const { return base::Span<const uint8_t>(bytes_.items, size_); }

 private:
  base::Array<uint8_t, longest_packet> bytes_;
  uint8_t size_;
};

Packet encode(const SpmGeneral& packet);
Packet encode(const SpmPowerUp& packet);
Packet encode(const SpmSettings& packet);

}  // namespace shark
}  // namespace bus
