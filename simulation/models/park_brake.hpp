// A spring-applied brake on one motor: the coil lifts it.
#pragma once

#include "simulation/time.hpp"

namespace simulation {

class ParkBrake {
 public:
  static constexpr double coil_current = 0.65;  // A
  static constexpr double hold_force = 400;     // N at the tread

  void step(bool is_coil_on, Time dt);
  bool is_engaged() const { return is_engaged_; }
  double friction() const { return is_engaged_ ? hold_force : 0; }  // N at the tread

 private:
  bool is_engaged_ = true;
  Time against_{};  // how long the coil has asked for the other state
};

}  // namespace simulation
