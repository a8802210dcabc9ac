// What the figures must be.
#pragma once

#include <string>
#include <vector>

#include "simulation/bench/figures.hpp"

namespace simulation::bench {

struct Target {
  std::string what;  // "answer, heaviest traffic"
  std::string wanted;
  std::string seen;
  bool is_met = false;
};

std::vector<Target> targets(const Figures& figures);

}  // namespace simulation::bench
