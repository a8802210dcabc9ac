// An EEPROM as a file: what `avrdude -U eeprom:r:FILE:i` (Intel HEX) or `:r` (raw) reads from a chip, and what the
// build writes as .eep.
#pragma once

#include <string>

#include "simulation/eeprom/layout.hpp"

namespace simulation::eeprom {

// The whole EEPROM; what the file does not hold is erased. Intel HEX is told from raw bytes by its first character.
// Throws std::runtime_error that names the file and says what is wrong with it.
Bytes load_file(const std::string& path);

}  // namespace simulation::eeprom
