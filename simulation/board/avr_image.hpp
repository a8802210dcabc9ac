// The flashed image: what an ELF or Intel HEX file puts into program memory, and an ELF's symbols.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

struct AvrImage {
  std::vector<std::uint8_t> flash;               // from address 0; gaps hold 0xFF
  std::map<std::string, std::uint32_t> symbols;  // RAM addresses without the linker's 0x800000; empty for a HEX file

  std::map<std::uint32_t, std::string> functions;  // by address; interrupts as __vector_N
  std::string compiler;                            // its name and version, as it wrote them; may be empty

  std::optional<std::uint32_t> address_of(const std::string& symbol) const;
  // A place in the code, for people: "spm::Spm::step+0x1a", or "0x2c4" without symbols.
  std::string place_of(std::uint32_t address) const;
};

// By suffix: .hex is Intel HEX, anything else ELF. Fuses and EEPROM contents of an ELF are left out, as they are
// when the image is flashed. Throws std::runtime_error that names the file.
AvrImage load_avr_image(const std::string& path);

}  // namespace simulation
