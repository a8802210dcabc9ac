// Runs the flashed image through both kinds of traffic and reads everything off.
#pragma once

#include <string>

#include "simulation/bench/figures.hpp"

namespace simulation::bench {

// Simulated minutes of each kind. The same figures whenever and wherever it runs. Throws std::runtime_error for an
// image that is none.
Figures measure(const std::string& image, double minutes);

}  // namespace simulation::bench
