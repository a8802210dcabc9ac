// What the EEPROM of a new board holds, the first copy of the settings: the image's .eep file. The simulator and a chip
// fresh from the tube begin with an erased one, which means the same.
#include "spm/settings_block.hpp"

namespace spm {

extern const SettingsBlock eeprom_settings;
__attribute__((section(".eeprom"), used)) extern constexpr SettingsBlock eeprom_settings =
    make_settings_block(Settings(), 0);
static_assert(settings_address == 0, "the .eeprom section begins with the first copy of the settings");

}  // namespace spm
