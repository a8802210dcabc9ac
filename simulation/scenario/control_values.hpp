// The values of a stick and a speed pot as people write them, for the remote's and for the attendant's.
#pragma once

#include <optional>

#include "simulation/scenario/reader.hpp"

namespace simulation::scenario {

constexpr int full_reading = 1023;  // of an axis
constexpr int full_pot = 255;

// A share of the stick's full travel, or neutral: 100% reads 1023, -100% reads 0.
std::optional<int> read_axis(const YAML::Node& value, Problems& problems);
// A share: 100% reads 255.
std::optional<int> read_pot(const YAML::Node& value, Problems& problems);

}  // namespace simulation::scenario
