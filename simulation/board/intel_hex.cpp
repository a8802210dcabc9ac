#include "simulation/board/intel_hex.hpp"

#include <stdexcept>
#include <string>

namespace simulation {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr const char* hex_digits = "0123456789ABCDEFabcdef";

Bytes hex_record(const std::string& line) {
  if (line.size() < 11 || line[0] != ':' || line.size() % 2 == 0 ||
      line.find_first_not_of(hex_digits, 1) != std::string::npos) {
    throw std::runtime_error("it is not an Intel HEX file");
  }
  Bytes bytes;
  std::uint8_t sum = 0;
  for (std::size_t i = 1; i < line.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(line.substr(i, 2), nullptr, 16)));
    sum = static_cast<std::uint8_t>(sum + bytes.back());
  }
  if (sum != 0 || bytes.size() != std::size_t{bytes[0]} + 5) {
    throw std::runtime_error("a line of the Intel HEX file is damaged: " + line);
  }
  return bytes;
}

}  // namespace

void parse_intel_hex(const Bytes& file,
                     const std::function<void(std::size_t, const std::uint8_t*, std::size_t)>& place) {
  std::size_t base = 0;
  std::string line;
  for (const std::uint8_t character : file) {
    if (character != '\n' && character != '\r') {
      line += static_cast<char>(character);
      continue;
    }
    if (line.empty()) {
      continue;
    }
    const Bytes record = hex_record(line);
    line.clear();
    const std::size_t field = std::size_t{record[1]} << 8 | record[2];
    const std::size_t payload = std::size_t{record[4]} << 8 | record[5];
    switch (record[3]) {
      case 0:
        place(base + field, record.data() + 4, record[0]);
        break;
      case 1:
        return;
      case 2:
        base = payload << 4;
        break;
      case 4:
        base = payload << 16;
        break;
      default:
        break;  // start addresses mean nothing to an AVR
    }
  }
  throw std::runtime_error("the Intel HEX file has no end record");
}

}  // namespace simulation
