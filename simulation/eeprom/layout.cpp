#include "simulation/eeprom/layout.hpp"

#include <algorithm>

namespace simulation::eeprom {
namespace {

constexpr std::size_t values_from = 4;
constexpr std::size_t checksum_size = 2;
constexpr std::uint8_t nothing = 0xFF;

unsigned crc16(const std::uint8_t* bytes, std::size_t count) {  // CCITT-FALSE
  unsigned crc = 0xFFFF;
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= static_cast<unsigned>(bytes[i]) << 8;
    for (int bit = 0; bit < 8; ++bit) {
      crc = ((crc & 0x8000U) != 0 ? crc << 1 ^ 0x1021U : crc << 1) & 0xFFFFU;
    }
  }
  return crc;
}

unsigned crc8(const std::uint8_t* bytes, std::size_t count) {  // polynomial 0x07
  unsigned crc = 0;
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = ((crc & 0x80U) != 0 ? crc << 1 ^ 0x07U : crc << 1) & 0xFFU;
    }
  }
  return crc;
}

unsigned word(const std::uint8_t* low) {
  return low[0] | static_cast<unsigned>(low[1]) << 8;
}

std::uint8_t low_of(unsigned value) {
  return static_cast<std::uint8_t>(value & 0xFFU);
}

std::uint8_t high_of(unsigned value) {
  return static_cast<std::uint8_t>(value >> 8 & 0xFFU);
}

bool is_later(std::uint16_t one, std::uint16_t other) {
  return static_cast<std::uint16_t>(one - other) < 0x8000U && one != other;
}

}  // namespace

SettingsCopy read_copy(const Bytes& eeprom, std::size_t copy, std::uint8_t version, std::uint8_t count) {
  const std::uint8_t* bytes = eeprom.data() + copy_at(copy);
  const std::size_t values_size = std::size_t{2} * count;
  SettingsCopy read;
  read.is_marked = bytes[0] != nothing;
  read.sequence = bytes[3];
  read.values.assign(bytes + values_from, bytes + values_from + values_size);
  read.is_sound = read.is_marked && bytes[1] == version && bytes[2] == count &&
                  word(bytes + values_from + values_size) == crc16(bytes + 1, values_from - 1 + values_size);
  return read;
}

Bytes make_copy(const Bytes& values, std::uint8_t version, std::uint8_t sequence) {
  Bytes bytes(values_from + values.size() + checksum_size);
  bytes[1] = version;
  bytes[2] = static_cast<std::uint8_t>(values.size() / 2);
  bytes[3] = sequence;
  std::copy(values.begin(), values.end(), bytes.begin() + values_from);
  const unsigned checksum = crc16(bytes.data() + 1, values_from - 1 + values.size());
  bytes[values_from + values.size()] = low_of(checksum);
  bytes.back() = high_of(checksum);
  return bytes;
}

std::optional<Bytes> values_in_force(const Bytes& eeprom, std::uint8_t version, std::uint8_t count) {
  const SettingsCopy first = read_copy(eeprom, 0, version, count);
  const SettingsCopy second = read_copy(eeprom, 1, version, count);
  if (first.is_sound && second.is_sound) {
    const bool is_second_newer = static_cast<std::uint8_t>(second.sequence - first.sequence) < 128;
    return is_second_newer ? second.values : first.values;
  }
  return first.is_sound ? std::optional(first.values) : second.is_sound ? std::optional(second.values) : std::nullopt;
}

std::optional<Record> read_record(const Bytes& eeprom, std::size_t place) {
  const std::uint8_t* bytes = eeprom.data() + place_at(place);
  if (bytes[0] == nothing || bytes[0] == 0 || bytes[7] != crc8(bytes, record_size - 1)) {
    return std::nullopt;
  }
  Record record;
  record.code = bytes[0];
  record.argument = bytes[1];
  record.sequence = static_cast<std::uint16_t>(place + places * bytes[2]);
  record.seconds = word(bytes + 3);
  record.starts = word(bytes + 5);
  return record;
}

void write_record(Bytes& eeprom, const Record& record) {
  std::uint8_t* bytes = eeprom.data() + place_at(record.sequence % places);
  bytes[0] = low_of(static_cast<unsigned>(record.code));
  bytes[1] = low_of(static_cast<unsigned>(record.argument));
  bytes[2] = high_of(record.sequence);
  bytes[3] = low_of(record.seconds);
  bytes[4] = high_of(record.seconds);
  bytes[5] = low_of(record.starts);
  bytes[6] = high_of(record.starts);
  bytes[7] = low_of(crc8(bytes, record_size - 1));
}

std::optional<Record> newest_record(const Bytes& eeprom) {
  std::optional<Record> newest;
  for (std::size_t place = 0; place < places; ++place) {
    const auto record = read_record(eeprom, place);
    if (record && (!newest || is_later(record->sequence, newest->sequence))) {
      newest = record;
    }
  }
  return newest;
}

std::vector<Record> read_log(const Bytes& eeprom) {
  std::vector<Record> records;
  for (std::size_t place = 0; place < places; ++place) {
    if (const auto record = read_record(eeprom, place)) {
      records.push_back(*record);
    }
  }
  if (const auto newest = newest_record(eeprom)) {
    std::sort(records.begin(), records.end(), [&](const Record& one, const Record& other) {
      return static_cast<std::uint16_t>(newest->sequence - one.sequence) >
             static_cast<std::uint16_t>(newest->sequence - other.sequence);
    });
  }
  return records;
}

}  // namespace simulation::eeprom
