// What stands at a scenario's head about the power module: what is fitted, and with which settings it starts.
#pragma once

#include "simulation/scenario/reader.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

struct HeadWord {
  std::string word;
  std::string example;
  std::string meaning;
  void (*parse)(const YAML::Node& value, Module& module, Problems& problems);
};

const std::vector<HeadWord>& head_words();

}  // namespace simulation::scenario
