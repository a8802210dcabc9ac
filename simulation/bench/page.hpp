// The figures for people: docs/performance.md, and its tables in columns for a terminal.
#pragma once

#include <string>
#include <vector>

#include "simulation/bench/figures.hpp"
#include "simulation/bench/targets.hpp"

namespace simulation::bench {

std::string tell_page(const Figures& figures, const std::vector<Target>& targets);
std::string tell_tables(const Figures& figures, const std::vector<Target>& targets);

}  // namespace simulation::bench
