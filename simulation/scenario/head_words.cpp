#include "simulation/scenario/head_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/eeprom/settings.hpp"
#include "simulation/scenario/spelling.hpp"

namespace simulation::scenario {
namespace {

void read_fitted(const std::optional<YAML::Node>& value, bool& is_fitted, Problems& problems) {
  if (value) {
    is_fitted = read_switch(*value, problems).value_or(is_fitted);
  }
}

void parse_fitted(const YAML::Node& value, Module& module, Problems& problems) {
  Table map(value, "fitted", problems);
  read_fitted(map.find("lighting"), module.has_lighting, problems);
  read_fitted(map.find("power module"), module.is_there, problems);
  map.done();
}

void parse_settings(const YAML::Node& value, Module& module, Problems& problems) {
  const auto& rows = eeprom::known_settings();
  std::vector<std::string> known;
  for (const auto& row : rows) {
    known.push_back(row.name);
  }
  eeprom::Chosen chosen;
  for (const Pair& pair : read_pairs(value, "settings", problems)) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.name == pair.key; });
    if (row == rows.end()) {
      problems.add(pair.key_node, fmt::format("no setting '{}'{}", pair.key, suggest(pair.key, known)));
    } else if (const auto number = read_integer(pair.value, row->least, row->most, problems)) {
      chosen[row->name] = *number;
    }
  }
  module.eeprom = eeprom::make_image(chosen);
}

}  // namespace

const std::vector<HeadWord>& head_words() {
  static const std::vector<HeadWord> words{
      {"fitted", "fitted: {lighting: no}",
       "the power module's option strap; 'power module: no' leaves out the power module itself, as in a factory",
       parse_fitted},
      {"settings", "settings: {sleep_timeout: 1, lock_mode_enable: 0}",
       "what the power module finds in its EEPROM at its first start, the rest being the defaults; without it the "
       "EEPROM is erased",
       parse_settings},
  };
  return words;
}

}  // namespace simulation::scenario
