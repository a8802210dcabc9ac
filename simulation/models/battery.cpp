#include "simulation/models/battery.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr double empty_volts = 23.2;
constexpr double full_volts = 25.4;
constexpr double full_charging_resistance = 0.25;  // ohm
constexpr double gassing_from = 0.9;               // of full charge
constexpr double capacity = 60.0 * 3600.0;         // ampere seconds

}  // namespace

double Battery::open_circuit() const {
  return forced_.value_or(empty_volts + (full_volts - empty_volts) * charge_);
}

double Battery::charging_resistance() const {
  const double gassing = std::max(0.0, charge_ - gassing_from) / (1 - gassing_from);
  return resistance + gassing * (full_charging_resistance - resistance);
}

void Battery::discharge(double amperes, double dt) {
  charge_ = std::clamp(charge_ - amperes * dt / capacity, 0.0, 1.0);
}

}  // namespace simulation
