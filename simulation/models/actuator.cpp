#include "simulation/models/actuator.hpp"

#include <algorithm>

namespace simulation {

void Actuator::step(bool extend, bool retract, Time dt) {
  if (extend != retract && moves()) {
    extended_ = std::clamp(extend ? extended_ + dt : extended_ - dt, Time{}, stroke);
  }
}

double Actuator::position() const {
  return seconds(extended_) / seconds(stroke);
}

double Actuator::current(bool extend, bool retract) const {
  if (extend == retract || has(ActuatorDamage::open)) {
    return 0;
  }
  if (has(ActuatorDamage::shorted)) {
    return shorted_current;
  }
  if (is_at_end(extend)) {
    return has(ActuatorDamage::no_end_switch) ? stalled_current : 0;
  }
  return has(ActuatorDamage::blocked) ? stalled_current : running_current;
}

}  // namespace simulation
