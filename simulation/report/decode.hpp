// Packets in words. The names here are the document's and are used everywhere a person reads or writes about
// a packet: bus log, failure reports, scenario conditions. Bit positions come from bus/shark/fields.hpp only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/bits.hpp"
#include "simulation/report/packet.hpp"

namespace simulation::report {

enum class Style { number, flag, state, month, year, version, hex, command };

struct FieldRow {
  const char* name;
  std::vector<base::Field> parts;  // highest bits first
  Style style = Style::flag;

  bool fits(std::size_t length) const;  // the packet has all of its bytes
  int read(const std::vector<std::uint8_t>& data) const;
  std::string show(int value) const;  // "on", "512", "Shark cable fault"
};

struct PacketRow {
  bus::shark::Type type;
  const char* name;
  std::size_t least_data;  // SB-5.3; 1 where the document gives none
  std::vector<FieldRow> fields;
  bool is_text = false;  // its data are characters
};

// Null for a type the document reserves.
const PacketRow* find_packet(std::uint8_t type);
const PacketRow& spm_general();

// "System OK" to "Unknown fault", by number; beyond: "undefined (0C)".
std::string system_state_name(int state);
constexpr int system_state_count = 11;
// Of the factory test, "read register"; by number.
std::string factory_command_name(int command);

// Characters in quotes; what cannot be printed is escaped, as in C: "hello\r", "\x83".
std::string quote(const std::string& text);

struct Reading {
  const FieldRow* field;
  int value;
};

struct Decoded {
  std::string name;               // "general", "power-up", "type 0B", "corrupt"
  std::vector<Reading> readings;  // empty where bits have no names
  std::string raw;                // what has no names: characters, data in hex, or the flaw
};

Decoded decode(const Packet& packet);

// All numbers and whatever is set.
std::string describe(const Decoded& packet);
// Only what differs from `before`, a packet of the same name; empty if nothing does.
std::string describe_change(const Decoded& before, const Decoded& packet);

}  // namespace simulation::report
