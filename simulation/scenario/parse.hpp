// A scenario file, read completely before anything runs.
#pragma once

#include <string>

#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

// Throws BadScenario with everything that is wrong with the text. `file` is for messages only.
Scenario parse_scenario(const std::string& text, const std::string& file);
Scenario load_scenario(const std::string& file);

}  // namespace simulation::scenario
