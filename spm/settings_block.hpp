// The settings as bytes in the EEPROM, in two copies:
//
//   0      1         2       3          4 ...                     n-1       n
//   mark   version   count   sequence   values, low byte first    CRC-16 of all from 1 on, low byte first
//
// The mark says whether there is a block at all: 0xFF = erased or being written, anything else = written to its end. A
// write goes to the copy that is not in use, one byte after the other: the mark away, everything else, the mark again.
// So a cut at any bit of any byte leaves the old settings or the new ones: while anything else changes there is no
// block, and a torn mark stands beside bytes that are whole.
//
// An erased EEPROM is a new board, not a fault, and stays erased. One copy that checks is good enough; the other is
// then written anew from it after the start. No copy that checks, and at least one that was written to its end, are
// lost settings: nothing is written, so that the loss shows until somebody stores others.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"
#include "spm/settings.hpp"

namespace spm {

constexpr uint8_t settings_copies = 2;
constexpr uint16_t settings_address = 0;  // in the EEPROM, of the first copy
constexpr uint8_t settings_spacing = 128;
constexpr uint8_t settings_version = 2;  // changes when a setting changes its place or meaning
constexpr uint8_t settings_size = 4 + 2 * setting_count + 2;
static_assert(settings_size <= settings_spacing, "a copy must end before the next one begins");

constexpr uint8_t is_being_written = 0xFF;  // the mark; an erased byte says the same
constexpr uint8_t is_written = 0x00;

using SettingsBlock = base::Array<uint8_t, settings_size>;

struct LoadedSettings {
  Settings settings;         // the defaults unless a copy was good
  bool is_lost = false;      // something was stored and none of it can be used
  bool is_copy_bad = false;  // one copy does not check; the other is used
  bool is_only_one = false;  // one copy is used, and the other is bad, torn or not there
  uint8_t next_copy = 0;     // where the next write goes
  uint8_t sequence = 0;      // of the copy in use
};

LoadedSettings read_settings(const SettingsBlock& first, const SettingsBlock& second);

constexpr uint16_t address_of_copy(uint8_t copy) {
  return static_cast<uint16_t>(settings_address + copy * uint16_t{settings_spacing});
}

// CRC-16/CCITT-FALSE: polynomial 0x1021, first value 0xFFFF; "123456789" gives 0x29B1.
constexpr uint16_t crc16_step(uint16_t crc, uint8_t byte) {
  uint8_t top = static_cast<uint8_t>((crc >> 8) ^ byte);  // eight steps of the division at once
  top = static_cast<uint8_t>(top ^ (top >> 4));
  const uint16_t wide = top;
  return static_cast<uint16_t>((crc << 8) ^ static_cast<uint16_t>(wide << 12) ^ static_cast<uint16_t>(wide << 5) ^
                               wide);
}

constexpr uint16_t crc16_of(const SettingsBlock& block) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 1; i < settings_size - 2; ++i) {
    crc = crc16_step(crc, block[i]);
  }
  return crc;
}

constexpr SettingsBlock make_settings_block(const Settings& settings, uint8_t sequence) {
  SettingsBlock block{};
  block[0] = is_written;
  block[1] = settings_version;
  block[2] = setting_count;
  block[3] = sequence;
  for (uint8_t i = 0; i < setting_count; ++i) {
    const uint16_t value = settings[static_cast<Setting>(i)];
    block[static_cast<uint8_t>(4 + 2 * i)] = static_cast<uint8_t>(value & 0xFF);
    block[static_cast<uint8_t>(5 + 2 * i)] = static_cast<uint8_t>(value >> 8);
  }
  const uint16_t crc = crc16_of(block);
  block[settings_size - 2] = static_cast<uint8_t>(crc & 0xFF);
  block[settings_size - 1] = static_cast<uint8_t>(crc >> 8);
  return block;
}

}  // namespace spm
