// `given:`, the situation a scenario starts from, as the steps that bring it about.
#pragma once

#include <vector>

#include "simulation/scenario/reader.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

// off, awake, "driving at 60%"
std::vector<Step> parse_given(const YAML::Node& node, Problems& problems);

}  // namespace simulation::scenario
