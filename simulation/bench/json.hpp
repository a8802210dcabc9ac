// The figures for a program to read.
#pragma once

#include <string>
#include <vector>

#include "simulation/bench/figures.hpp"
#include "simulation/bench/targets.hpp"

namespace simulation::bench {

std::string tell_json(const Figures& figures, const std::vector<Target>& targets);

}  // namespace simulation::bench
