#include "spm/settings_block.hpp"

namespace spm {

namespace {

uint16_t word_at(const SettingsBlock& block, uint8_t place) {
  return static_cast<uint16_t>(block[place] | (static_cast<uint16_t>(block[static_cast<uint8_t>(place + 1)]) << 8));
}

// All or nothing (H-20): false if anything in it cannot be used.
bool take(const SettingsBlock& block, Settings& settings) {
  if (block[1] != settings_version || block[2] != setting_count ||
      word_at(block, settings_size - 2) != crc16_of(block)) {
    return false;
  }
  for (uint8_t i = 0; i < setting_count; ++i) {
    if (!settings.set(static_cast<Setting>(i), word_at(block, static_cast<uint8_t>(4 + 2 * i)))) {  // H-21
      return false;
    }
  }
  return true;
}

}  // namespace

LoadedSettings read_settings(const SettingsBlock& first, const SettingsBlock& second) {
  LoadedSettings loaded;
  bool is_any_sound = false;
  bool is_any_bad = false;
  bool are_both_sound = false;
  for (uint8_t copy = 0; copy < settings_copies; ++copy) {
    const SettingsBlock& block = copy == 0 ? first : second;
    Settings settings;
    if (block[0] == is_being_written) {
      continue;
    }
    if (!take(block, settings)) {
      is_any_bad = true;
      continue;
    }
    const bool is_newer = static_cast<uint8_t>(block[3] - loaded.sequence) < 128;
    if (!is_any_sound || is_newer) {
      loaded.settings = settings;
      loaded.sequence = block[3];
      loaded.next_copy = copy == 0 ? uint8_t{1} : uint8_t{0};
    }
    are_both_sound = is_any_sound;
    is_any_sound = true;
  }
  loaded.is_lost = is_any_bad && !is_any_sound;
  loaded.is_copy_bad = is_any_bad && is_any_sound;
  loaded.is_only_one = is_any_sound && !are_both_sound;
  return loaded;
}

}  // namespace spm
