// The image beside somebody who babbles: all of the time, half of the time, and in every gap between the turns (H-23).
#pragma once

#include <string>
#include <vector>

#include "simulation/bench/figures.hpp"

namespace simulation::bench {

// Simulated minutes of noise of each kind, beginning while the chair drives.
std::vector<NoiseFigures> measure_noise(const std::string& image, double minutes);

}  // namespace simulation::bench
