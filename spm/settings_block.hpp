// The settings as bytes in the EEPROM:
//
//   0         1       2 ...                     n         n+1
//   version   count   values, low byte first    CRC-16 of all before it, low byte first
//
// An erased block is a new board, not a fault; a block that was written once and does not check is one.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"
#include "spm/settings.hpp"

namespace spm {

constexpr uint16_t settings_address = 0;  // in the EEPROM
constexpr uint8_t settings_version = 1;   // changes when a setting changes its place or meaning
constexpr uint8_t settings_size = 2 + 2 * setting_count + 2;

using SettingsBlock = base::Array<uint8_t, settings_size>;

struct LoadedSettings {
  Settings settings;     // the defaults unless the block was good
  bool is_lost = false;  // something was stored and cannot be used
};

LoadedSettings read_settings(const SettingsBlock& block);

// CRC-16/CCITT-FALSE: polynomial 0x1021, first value 0xFFFF; "123456789" gives 0x29B1.
constexpr uint16_t crc16_step(uint16_t crc, uint8_t byte) {
  crc = static_cast<uint16_t>(crc ^ (static_cast<uint16_t>(byte) << 8));
  for (uint8_t i = 0; i < 8; ++i) {
    const bool carries = (crc & 0x8000U) != 0;
    crc = static_cast<uint16_t>(crc << 1);
    if (carries) {
      crc = static_cast<uint16_t>(crc ^ 0x1021U);
    }
  }
  return crc;
}

constexpr uint16_t crc16_of(const SettingsBlock& block) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < settings_size - 2; ++i) {
    crc = crc16_step(crc, block[i]);
  }
  return crc;
}

constexpr SettingsBlock make_settings_block(const Settings& settings) {
  SettingsBlock block{};
  block[0] = settings_version;
  block[1] = setting_count;
  for (uint8_t i = 0; i < setting_count; ++i) {
    const uint16_t value = settings[static_cast<Setting>(i)];
    block[static_cast<uint8_t>(2 + 2 * i)] = static_cast<uint8_t>(value & 0xFF);
    block[static_cast<uint8_t>(3 + 2 * i)] = static_cast<uint8_t>(value >> 8);
  }
  const uint16_t crc = crc16_of(block);
  block[settings_size - 2] = static_cast<uint8_t>(crc & 0xFF);
  block[settings_size - 1] = static_cast<uint8_t>(crc >> 8);
  return block;
}

}  // namespace spm
