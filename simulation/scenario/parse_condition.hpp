// YAML to conditions.
#pragma once

#include <vector>

#include "simulation/scenario/condition.hpp"
#include "simulation/scenario/reader.hpp"

namespace simulation::scenario {

// The map under `expect`, `hold` or `never`.
std::vector<Condition> parse_conditions(const YAML::Node& node, Problems& problems);

}  // namespace simulation::scenario
