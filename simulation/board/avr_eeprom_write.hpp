// A byte on its way into the EEPROM's cell.
#pragma once

#include <cstdint>

namespace simulation {

struct EepromWrite {
  std::uint16_t address = 0;
  std::uint8_t before = 0;
  std::uint8_t after = 0;
};

}  // namespace simulation
