// What lies where in the power module's EEPROM, taken from docs/architecture.md a second time: no line of the product
// stands in here, so that one checks the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace simulation::eeprom {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t size = 4096;

// ---- settings: mark, version, count, sequence, values low byte first, CRC-16 of all but the mark

constexpr std::size_t copies = 2;
constexpr std::size_t copy_at(std::size_t copy) {
  return 128 * copy;
}

struct SettingsCopy {
  bool is_marked = false;  // written to its end, says the mark
  bool is_sound = false;   // and version, count and checksum agree
  std::uint8_t sequence = 0;
  Bytes values;  // two bytes each
};

// Of which there are `count` in this version of the layout; ranges are not looked at.
SettingsCopy read_copy(const Bytes& eeprom, std::size_t copy, std::uint8_t version, std::uint8_t count);
Bytes make_copy(const Bytes& values, std::uint8_t version, std::uint8_t sequence);
// The values that count: those of the newer sound copy, or nothing.
std::optional<Bytes> values_in_force(const Bytes& eeprom, std::uint8_t version, std::uint8_t count);

// ---- event log: code, argument, lap, seconds, starts, CRC-8

constexpr std::size_t places = 256;
constexpr std::size_t record_size = 8;
constexpr std::size_t place_at(std::size_t place) {
  return 2048 + record_size * place;
}

struct Record {
  std::uint16_t sequence = 0;
  int code = 0;
  int argument = 0;
  unsigned seconds = 0;  // since that start; 65535 = that or more
  unsigned starts = 0;   // the start that it belongs to, counted from the first
};

std::optional<Record> read_record(const Bytes& eeprom, std::size_t place);
void write_record(Bytes& eeprom, const Record& record);
// All of them, oldest first.
std::vector<Record> read_log(const Bytes& eeprom);
// The one with the last number, and nothing in an empty log.
std::optional<Record> newest_record(const Bytes& eeprom);

}  // namespace simulation::eeprom
