// The packets of section 5, a row each: who sends a type, how much data we must hear, and how much we say.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "drivers/base/flash.hpp"

namespace bus {
namespace shark {

enum class Sender : uint8_t {
  nobody,  // reserved
  remote,
  attendant,
  remote_or_attendant,
  tester,  // in production, without a power module
  power_module,
};

struct PacketRow {
  uint8_t type;
  Sender sender;
  uint8_t least_heard;  // data bytes; 0 = not for us (SB-5.3)
  uint8_t most_said;    // data bytes; 0 = never said by us
};

constexpr PacketRow row(Type type, Sender sender, uint8_t least_heard, uint8_t most_said) {
  return PacketRow{static_cast<uint8_t>(type), sender, least_heard, most_said};
}

constexpr uint8_t type_count = 16;

// SB-5.1: types that the document leaves out are reserved. The table is in flash: at run time only flash_byte() reads
// it.
constexpr PacketRow packet_table[type_count] IN_FLASH = {
    // clang-format off
    //                                                             heard  said
    row(Type::sr_general,           Sender::remote,                6,     0),
    row(Type::spm_general,          Sender::power_module,          0,     7),
    row(Type::sr_hhp_data,          Sender::remote,                1,     0),
    row(Type::spm_hhp_data,         Sender::power_module,          0,     longest_data),
    row(Type::sr_power_up,          Sender::remote,                6,     0),
    row(Type::spm_power_up,         Sender::power_module,          0,     1),
    row(Type::joystick_calibration, Sender::remote_or_attendant,   1,     0),
    row(Type::factory_test,         Sender::tester,                3,     0),
    row(Type::sacu_general,         Sender::attendant,             6,     0),
    row(Type::sacu_power_up,        Sender::attendant,             7,     0),
    row(Type::spm_settings,         Sender::power_module,          0,     2),
    // clang-format on
    {0xB, Sender::nobody, 0, 0},
    {0xC, Sender::nobody, 0, 0},
    {0xD, Sender::nobody, 0, 0},
    {0xE, Sender::nobody, 0, 0},
    {0xF, Sender::nobody, 0, 0},  // as a single byte it is TF (SB-2.6)
};

constexpr uint8_t data_said(Type type) {
  return packet_table[static_cast<uint8_t>(type)].most_said;
}

// With start byte and checksum.
constexpr uint8_t bytes_said(Type type) {
  return static_cast<uint8_t>(data_said(type) + 2);
}

constexpr bool is_packet_table_sound() {
  for (uint8_t type = 0; type < type_count; ++type) {
    const PacketRow& row = packet_table[type];
    const bool is_heard = row.least_heard != 0;
    const bool is_said = row.most_said != 0;
    if (row.type != type || is_said != (row.sender == Sender::power_module) ||
        is_heard != (row.sender != Sender::power_module && row.sender != Sender::nobody)) {
      return false;
    }
  }
  return true;
}
static_assert(is_packet_table_sound(), "rows stand in the order of their types; each is heard, said, or reserved");

}  // namespace shark
}  // namespace bus
