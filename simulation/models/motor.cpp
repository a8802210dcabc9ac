#include "simulation/models/motor.hpp"

namespace simulation {

double Motor::back_emf(double speed) const {
  return constant * speed;
}

double Motor::current(double volts, double speed) const {
  return (volts - back_emf(speed)) / resistance;
}

double Motor::force(double amperes) const {
  return constant * amperes;
}

}  // namespace simulation
