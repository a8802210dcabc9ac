#include "simulation/models/battery.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr double empty_volts = 23.2;
constexpr double full_volts = 25.4;
constexpr double capacity = 60.0 * 3600.0;  // ampere seconds

}  // namespace

double Battery::open_circuit() const {
  return forced_.value_or(empty_volts + (full_volts - empty_volts) * charge_);
}

void Battery::discharge(double amperes, double dt) {
  charge_ = std::clamp(charge_ - amperes * dt / capacity, 0.0, 1.0);
}

}  // namespace simulation
