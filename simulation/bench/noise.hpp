// The image beside somebody who babbles: all of the time, half of the time, and in every gap between the turns (H-23).
#pragma once

#include <string>
#include <vector>

#include "simulation/bench/figures.hpp"

namespace simulation::bench {

// Simulated minutes of noise in the gaps, 4 s of the other kinds, beginning while the chair drives.
std::vector<NoiseFigures> measure_noise(const std::string& image, double minutes);

}  // namespace simulation::bench
