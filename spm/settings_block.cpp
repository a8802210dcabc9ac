#include "spm/settings_block.hpp"

namespace spm {

namespace {

uint16_t word_at(const SettingsBlock& block, uint8_t place) {
  return static_cast<uint16_t>(block[place] | (static_cast<uint16_t>(block[static_cast<uint8_t>(place + 1)]) << 8));
}

bool is_erased(const SettingsBlock& block) {
  for (const uint8_t byte : block) {
    if (byte != 0xFF) {
      return false;
    }
  }
  return true;
}

bool is_sound(const SettingsBlock& block) {
  return block[0] == settings_version && block[1] == setting_count &&
         word_at(block, settings_size - 2) == crc16_of(block);
}

}  // namespace

LoadedSettings read_settings(const SettingsBlock& block) {
  LoadedSettings loaded;
  if (is_erased(block)) {
    return loaded;
  }
  loaded.is_lost = !is_sound(block);
  for (uint8_t i = 0; i < setting_count && !loaded.is_lost; ++i) {
    loaded.is_lost = !loaded.settings.set(static_cast<Setting>(i), word_at(block, static_cast<uint8_t>(2 + 2 * i)));
  }
  if (loaded.is_lost) {  // H-20: all or nothing
    loaded.settings = Settings();
  }
  return loaded;
}

}  // namespace spm
