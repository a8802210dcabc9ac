// Words of the wire for tests: the arithmetic of the document done a second time, without a line of the product, and
// the packets most tests need, as literals. Worked out by hand from the tables of section 5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace support {

using Bytes = std::vector<std::uint8_t>;

inline Bytes operator+(Bytes first, const Bytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// SB-2.5, as the document says it: what the low 7 bits of the sum lack to 127, with bit 7 set.
inline std::uint8_t checksum_of(const Bytes& start_and_data) {
  unsigned total = 0;
  for (const std::uint8_t byte : start_and_data) {
    total += byte;
  }
  return static_cast<std::uint8_t>(128 + (127 - total % 128));
}

inline Bytes sealed(Bytes start_and_data) {
  start_and_data.push_back(checksum_of(start_and_data));
  return start_and_data;
}

// A whole packet of any type, with `length` equal data bytes.
inline Bytes packet_of(unsigned type, unsigned length, std::uint8_t data = 0x80) {
  Bytes bytes{static_cast<std::uint8_t>((length - 1) * 16 + type)};
  bytes.insert(bytes.end(), length, data);
  return sealed(bytes);
}

// The same packet with its checksum off by one bit.
inline Bytes corrupted(Bytes packet) {
  packet.at(packet.size() - 1) ^= 0x01;
  return packet;
}

// An SR general (SB-00.1); bytes 4 to 6 without their markers.
struct SrWords {
  unsigned speed = 512;
  unsigned direction = 512;
  unsigned pot = 0;
  unsigned byte4 = 0;
  unsigned byte5 = 0;
  unsigned byte6 = 0;
};

inline Bytes sr_general(SrWords words) {
  const auto marked = [](unsigned value) { return static_cast<std::uint8_t>(128 + value); };
  return sealed({0x60, marked(words.speed / 8), marked(words.direction / 8), marked(words.pot / 2),
                 marked(words.pot % 2 * 64 + words.speed % 8 * 8 + words.direction % 8), marked(words.byte4),
                 marked(words.byte5), marked(words.byte6)});
}

// Literal packets, without TF unless they say so.
namespace wire {

inline const Bytes tf{0x0F};

// A remote of a real chair: type 2, 2006-11, serial 4810, version 2.5, actuators and lighting.
inline const Bytes sr_power_up{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1};
inline const Bytes spm_power_up{0x05, 0x80, 0xFA};

inline const Bytes at_rest{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9F};
// Captured: forward 1022, pot 0; and reverse 7, pot 0.
inline const Bytes forward_slow{0x60, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x80, 0xAA};
inline const Bytes reverse_slow{0x60, 0x80, 0xC0, 0x80, 0xBF, 0x80, 0x84, 0x80, 0x9C};
// The same at pot 255.
inline const Bytes forward_fast{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x80, 0x80, 0xEF};
inline const Bytes reverse_fast{0x60, 0x80, 0xC0, 0xFF, 0xFF, 0x80, 0x80, 0x80, 0xE1};
// At rest, with one bit each.
inline const Bytes joystick_error{0x60, 0xC0, 0xC0, 0x80, 0x80, 0xC0, 0x80, 0x80, 0xDF};
inline const Bytes pot_error{0x60, 0xC0, 0xC0, 0x80, 0x80, 0xA0, 0x80, 0x80, 0xFF};
inline const Bytes local_fault{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x90, 0x80, 0x80, 0x8F};
inline const Bytes charger_inhibit{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x88, 0x80, 0x80, 0x97};
inline const Bytes button_down{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x84, 0x80, 0x80, 0x9B};
inline const Bytes remote_inhibit{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x88, 0x80, 0x97};
inline const Bytes calibrating{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x82, 0x80, 0x9D};
inline const Bytes confirm{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x81, 0x80, 0x9E};
inline const Bytes non_critical_fault{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0xA0, 0xFF};
// A reserved type, sound.
inline const Bytes unknown_type{0x0B, 0x80, 0xF4};

}  // namespace wire

}  // namespace support
