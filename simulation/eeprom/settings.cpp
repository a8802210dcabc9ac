#include "simulation/eeprom/settings.hpp"

#include <algorithm>

#include "spm/settings_block.hpp"

namespace simulation::eeprom {

const std::vector<SettingRow>& known_settings() {
  static const std::vector<SettingRow> rows{
#define SPM_SETTING(name, initial, least, most, unit, reason) {#name, initial, least, most, #unit, reason},
#include "spm/settings_list.inc"
#undef SPM_SETTING
  };
  return rows;
}

Bytes make_image(const Chosen& chosen) {
  Bytes values;
  for (const SettingRow& row : known_settings()) {
    const auto found = chosen.find(row.name);
    const auto value = static_cast<unsigned>(found == chosen.end() ? row.initial : found->second);
    values.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    values.push_back(static_cast<std::uint8_t>(value >> 8));
  }
  Bytes image(size, 0xFF);
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const Bytes bytes = make_copy(values, spm::settings_version, static_cast<std::uint8_t>(copy));
    std::copy(bytes.begin(), bytes.end(), image.begin() + static_cast<std::ptrdiff_t>(copy_at(copy)));
  }
  return image;
}

}  // namespace simulation::eeprom
