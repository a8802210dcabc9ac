#include "simulation/report/decode.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace simulation::report {
namespace {

std::string show_version(int version) {
  if (version < 0x10) {
    return version == 0 ? "before 1.0" : version == 1 ? "1.0" : version == 2 ? "1.1 up to RC1" : "undefined";
  }
  return fmt::format("{}.{}{}", version >> 4 & 7, version & 7, (version & 8) != 0 ? " pre-release" : "");
}

std::string label(const Reading& reading) {
  const FieldRow& field = *reading.field;
  if (field.style != Style::flag) {
    return fmt::format("{} {}", field.name, field.show(reading.value));
  }
  return reading.value != 0 ? field.name : fmt::format("{} off", field.name);
}

bool is_worth_telling(const Reading& reading) {
  const Style style = reading.field->style;
  return reading.value != 0 || (style != Style::flag && style != Style::state);
}

std::string escape(unsigned char character) {
  switch (character) {
    case '\r':
      return "\\r";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '"':
    case '\\':
      return fmt::format("\\{:c}", character);
    default:
      break;
  }
  const bool is_printable = character >= 0x20 && character < 0x7F;
  return is_printable ? fmt::format("{:c}", character) : fmt::format("\\x{:02x}", character);
}

}  // namespace

std::string quote(const std::string& text) {
  std::string quoted;
  for (const char character : text) {
    quoted += escape(static_cast<unsigned char>(character));
  }
  return '"' + quoted + '"';
}

bool FieldRow::fits(std::size_t length) const {
  return std::all_of(parts.begin(), parts.end(), [&](base::Field part) { return part.byte < length; });
}

int FieldRow::read(const std::vector<std::uint8_t>& data) const {
  int value = 0;
  for (const base::Field& part : parts) {
    value = (value << (part.high - part.low + 1)) | base::read(data.data(), part);
  }
  return value;
}

std::string FieldRow::show(int value) const {
  switch (style) {
    case Style::flag:
      return value != 0 ? "on" : "off";
    case Style::state:
      return fmt::format("{:02X} {}", value, system_state_name(value));
    case Style::year:
      return fmt::format("{}", 2000 + value);
    case Style::version:
      return show_version(value);
    case Style::hex:
      return fmt::format("{:02X}", value);
    case Style::command:
      return fmt::format("{:02X} {}", value, factory_command_name(value));
    case Style::month:
    case Style::number:
      break;
  }
  return fmt::format("{}", value);
}

Decoded decode(const Packet& packet) {
  if (packet.kind == Packet::Kind::finished) {
    return {"TF", {}, ""};
  }
  if (packet.kind == Packet::Kind::corrupt) {
    return {"corrupt", {}, fmt::format("{}: {}", packet.flaw, hex(packet.bytes))};
  }
  const auto data = packet.data();
  const PacketRow* row = find_packet(packet.type());
  if (row == nullptr) {
    return {fmt::format("type {:02X}", packet.type()), {}, hex(packet.bytes)};
  }
  if (data.size() < row->least_data) {
    return {row->name, {}, fmt::format("too short: {}", hex(packet.bytes))};
  }
  Decoded decoded{row->name, {}, row->is_text ? quote({data.begin(), data.end()}) : ""};
  for (const FieldRow& field : row->fields) {
    if (field.fits(data.size())) {
      decoded.readings.push_back({&field, field.read(data)});
    }
  }
  return decoded;
}

std::string describe(const Decoded& packet) {
  std::vector<std::string> words;
  for (const Reading& reading : packet.readings) {
    if (is_worth_telling(reading)) {
      words.push_back(label(reading));
    }
  }
  if (!packet.raw.empty()) {
    words.push_back(packet.raw);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string describe_change(const Decoded& before, const Decoded& packet) {
  if (before.readings.size() != packet.readings.size()) {
    return describe(packet);
  }
  std::vector<std::string> words;
  for (std::size_t i = 0; i < packet.readings.size(); ++i) {
    if (packet.readings[i].value != before.readings[i].value) {
      words.push_back(label(packet.readings[i]));
    }
  }
  if (packet.raw != before.raw) {
    words.push_back(packet.raw);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace simulation::report
