// What the EEPROM of a new board holds, the image's .eep file: the defaults, in both copies, so that writing it over an
// older board's settings leaves none of them. The simulator and a chip fresh from the tube begin with an erased one,
// which means the same.
#include "spm/settings_block.hpp"

namespace spm {

namespace {

struct EepromImage {
  SettingsBlock first;
  uint8_t unused[settings_spacing - settings_size];
  SettingsBlock second;
};

constexpr uint8_t before_the_first = 255;

}  // namespace

extern const EepromImage eeprom_settings;
__attribute__((section(".eeprom"), used)) extern constexpr EepromImage eeprom_settings = {
    make_settings_block(Settings(), 0), {}, make_settings_block(Settings(), before_the_first)};
static_assert(settings_address == 0, "the .eeprom section begins with the first copy of the settings");
static_assert(sizeof(EepromImage) == address_of_copy(1) + settings_size, "the second copy lies where it is looked for");

}  // namespace spm
