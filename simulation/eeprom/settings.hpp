// The settings by name, with their ranges, which are the product's (spm/settings_list.inc), and an EEPROM that holds
// chosen ones. How they lie there is told a second time, by layout.hpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "simulation/eeprom/layout.hpp"

namespace simulation::eeprom {

struct SettingRow {
  std::string name;
  int initial = 0;
  int least = 0;
  int most = 0;
  std::string unit;    // "permille", "choice"
  std::string reason;  // clause, and what it is for
};

// In the order of the list, which is that of the EEPROM.
const std::vector<SettingRow>& known_settings();

using Chosen = std::map<std::string, int>;  // by name; each known and in its range

// Erased but for both copies of the settings: defaults, and what is chosen. An empty event log.
Bytes make_image(const Chosen& chosen);

}  // namespace simulation::eeprom
