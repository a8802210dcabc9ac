// An EEPROM in memory, and a storage that is stepped on it as Board::store() does, time left out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spm/storage.hpp"

namespace support {

using Eeprom = std::array<std::uint8_t, 4096>;

inline Eeprom erased_eeprom() {
  Eeprom eeprom;
  eeprom.fill(0xFF);
  return eeprom;
}

inline spm::SettingsBlock copy_in(const Eeprom& eeprom, std::uint8_t copy) {
  spm::SettingsBlock block{};
  for (std::uint8_t i = 0; i < block.size(); ++i) {
    block[i] = eeprom[copy * 128U + i];
  }
  return block;
}

inline spm::RecordBytes place_in(const Eeprom& eeprom, unsigned place) {
  spm::RecordBytes bytes{};
  for (std::uint8_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = eeprom[2048 + 8 * place + i];
  }
  return bytes;
}

// A start: loaded, and looked through.
struct Started {
  explicit Started(const Eeprom& eeprom) {
    loaded = storage.load(copy_in(eeprom, 0), copy_in(eeprom, 1));
    while (storage.log().is_looking()) {
      storage.log().look(place_in(eeprom, storage.log().place_to_look_at()));
    }
  }

  void note(std::uint8_t code, std::uint8_t argument = 0) {
    faults::Event event;
    event.code = code;
    event.argument = argument;
    storage.note(base::Span<const faults::Event>(&event, 1));
  }

  void seconds(int count) {
    for (int i = 0; i < count * 1000; ++i) {
      storage.step();
    }
  }

  // All that it wants to write, in order; done in `eeprom` too.
  std::vector<spm::ByteWrite> write_all(Eeprom& eeprom) {
    std::vector<spm::ByteWrite> writes;
    for (auto write = storage.next_write(); write; write = storage.next_write()) {
      eeprom[write->address] = write->value;
      writes.push_back(*write);
    }
    return writes;
  }

  spm::Storage storage;
  spm::LoadedSettings loaded;
};

// What a cut during the write of a byte may leave: old, erased, new, every mixture of old and new by one bit, whatever.
inline std::vector<std::uint8_t> torn(std::uint8_t before, std::uint8_t after, std::uint32_t& seed) {
  if (before == after) {
    return {after};  // drivers::store does not touch it
  }
  std::vector<std::uint8_t> outcomes{before, 0xFF, after};
  for (unsigned bit = 0; bit < 8; ++bit) {
    outcomes.push_back(static_cast<std::uint8_t>(before ^ 1U << bit));
    outcomes.push_back(static_cast<std::uint8_t>(after ^ 1U << bit));
  }
  for (int i = 0; i < 3; ++i) {
    seed = seed * 1664525U + 1013904223U;
    outcomes.push_back(static_cast<std::uint8_t>(seed >> 24));
  }
  return outcomes;
}

}  // namespace support
