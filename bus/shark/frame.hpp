// A packet as it stands on the wire, without meaning (SB-2.3 to SB-2.6):
//
//     start      data 1 .. 8                 checksum
//   0LLLTTTT   1ddddddd ... 1ddddddd         1ccccccc       L = data length - 1, T = type
//
// and the one byte that ends a turn, TF = 0x0F.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"

namespace bus {
namespace shark {

constexpr uint8_t transmit_finished = 0x0F;  // SB-2.6
constexpr uint8_t marker_bit = 0x80;         // SB-2.4: clear in start bytes and TF, set everywhere else
constexpr uint8_t longest_data = 8;          // SB-2.3
constexpr uint8_t longest_packet = longest_data + 2;

// The packet types of section 5. Types without a name are reserved: discarded, not corrupt (SB-5.1).
enum class Type : uint8_t {
  sr_general = 0x0,
  spm_general = 0x1,
  sr_hhp_data = 0x2,
  spm_hhp_data = 0x3,
  sr_power_up = 0x4,
  spm_power_up = 0x5,
  joystick_calibration = 0x6,
  factory_test = 0x7,
  sacu_general = 0x8,
  sacu_power_up = 0x9,
  spm_settings = 0xA,
};

struct Frame {
  uint8_t type = 0;                              // 0 to 15, whether known or not
  uint8_t length = 0;                            // 1 to 8
  base::Array<uint8_t, longest_data> data = {};  // marker bits stripped

  bool is(Type wanted) const { return type == static_cast<uint8_t>(wanted); }
};

constexpr bool has_marker(uint8_t byte) {
  return (byte & marker_bit) != 0;
}
constexpr uint8_t type_of(uint8_t start) {
  return start & 0x0F;
}
constexpr uint8_t length_of(uint8_t start) {
  return static_cast<uint8_t>(((start >> 4) & 0x07) + 1);
}
constexpr uint8_t start_byte(Type type, uint8_t length) {
  return static_cast<uint8_t>(((length - 1) << 4) | static_cast<uint8_t>(type));
}
// SB-2.5. `sum` is the sum of start byte and data bytes as sent; its low 7 bits count.
constexpr uint8_t checksum(uint8_t sum) {
  return static_cast<uint8_t>(marker_bit | (0x7F - (sum & 0x7F)));
}

}  // namespace shark
}  // namespace bus
