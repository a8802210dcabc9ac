#include "spm/settings.hpp"

#include "drivers/base/flash.hpp"

namespace spm {

namespace {

const SettingRange ranges[setting_count] IN_FLASH = {
#define SPM_SETTING(name, initial, least, most, unit, reason) {initial, least, most},
#include "spm/settings_list.inc"
#undef SPM_SETTING
};

#define SPM_SETTING(name, initial, least, most, unit, reason) \
  static_assert((least) <= (initial) && (initial) <= (most), "the default of " #name " lies outside its range");
#include "spm/settings_list.inc"
#undef SPM_SETTING

}  // namespace

SettingRange range_of(Setting setting) {
  return base::from_flash(ranges[static_cast<uint8_t>(setting)]);
}

uint16_t Settings::sum() const {
  uint16_t sum = 0;
  for (const uint16_t value : values_) {
    sum = static_cast<uint16_t>(sum + value);
  }
  return sum;
}

void Settings::force_into_range() {
  for (uint8_t i = 0; i < setting_count; ++i) {
    const SettingRange range = range_of(static_cast<Setting>(i));
    if (values_[i] < range.least || values_[i] > range.most) {
      values_[i] = range.initial;
    }
  }
}

bool Settings::set(Setting setting, uint16_t value) {
  const SettingRange range = range_of(setting);
  if (value < range.least || value > range.most) {
    return false;
  }
  values_[static_cast<uint8_t>(setting)] = value;
  return true;
}

}  // namespace spm
