// What a user may adjust. The list itself, with defaults and ranges, is settings_list.inc.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"

namespace spm {

enum class Setting : uint8_t {
#define SPM_SETTING(name, initial, least, most, unit, reason) name,
#include "spm/settings_list.inc"
#undef SPM_SETTING
};

constexpr uint8_t setting_count = 0
#define SPM_SETTING(name, initial, least, most, unit, reason) +1
#include "spm/settings_list.inc"
#undef SPM_SETTING
    ;

struct SettingRange {
  uint16_t initial;
  uint16_t least;
  uint16_t most;
};

SettingRange range_of(Setting setting);

// One value for each setting, always inside its range: set() refuses anything else.
class Settings {
 public:
  // Defaults.
  constexpr Settings()
      : values_{{
#define SPM_SETTING(name, initial, least, most, unit, reason) initial,
#include "spm/settings_list.inc"
#undef SPM_SETTING
        }} {
  }

  constexpr uint16_t operator[](Setting setting) const {
    return values_[static_cast<uint8_t>(setting)];
  }
  // Changes with every bit (H-27).
  uint16_t sum() const;
  // Where memory has changed by itself: what is out of its range is its default again (H-21).
  void force_into_range();
  // False, and nothing changed, if the value is out of range.
  bool set(Setting setting, uint16_t value);

 private:
  base::Array<uint16_t, setting_count> values_;
};

}  // namespace spm
