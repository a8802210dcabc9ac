#include "simulation/eeprom/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "simulation/board/intel_hex.hpp"

namespace simulation::eeprom {
namespace {

void place(Bytes& contents, std::size_t address, const std::uint8_t* data, std::size_t count) {
  if (address + count > size) {
    throw std::runtime_error(
        fmt::format("it has a byte at address {}, and the EEPROM ends at {}; is it the flash's file?",
                    address + count - 1, size - 1));
  }
  std::copy(data, data + count, contents.begin() + static_cast<std::ptrdiff_t>(address));
}

Bytes parse(const Bytes& file) {
  if (file.empty()) {
    throw std::runtime_error("it is empty");
  }
  Bytes contents(size, 0xFF);
  if (file.front() == ':') {
    parse_intel_hex(file, [&](std::size_t address, const std::uint8_t* data, std::size_t count) {
      place(contents, address, data, count);
    });
  } else if (file.size() == size) {
    contents = file;
  } else {
    throw std::runtime_error(fmt::format(
        "it is neither Intel HEX nor the {} raw bytes of an ATmega1284P's EEPROM ({} bytes)", size, file.size()));
  }
  return contents;
}

}  // namespace

Bytes load_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path)) {
    throw std::runtime_error("no file at '" + path + "'; avrdude reads a chip's EEPROM with -U eeprom:r:eeprom.hex:i");
  }
  const Bytes file{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  try {
    return parse(file);
  } catch (const std::exception& reason) {
    throw std::runtime_error("cannot read an EEPROM from '" + path + "': " + reason.what());
  }
}

}  // namespace simulation::eeprom
