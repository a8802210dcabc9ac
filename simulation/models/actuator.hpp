// A linear actuator of a seat: a motor on a spindle, with a switch at each end of its travel. A switch opens at its
// end; a diode across it lets the current for the way back pass.
//
// Assumptions: load and supply do not change its speed; it stops at once. With both outputs on, its motor has the same
// voltage at both ends: no current, no movement.
#pragma once

#include <array>
#include <cstddef>

#include "simulation/time.hpp"

namespace simulation {

// Anything of it may be there at once; a wire that is off hides the rest, a short all but that.
enum class ActuatorDamage {
  open,           // the wire is off: no current
  shorted,        // it draws far too much and does not move
  blocked,        // something is in the way: it stalls
  no_end_switch,  // it runs against the end of its travel and stalls there
};

class Actuator {
 public:
  static constexpr Time stroke = 10s;           // from end to end
  static constexpr double running_current = 4;  // A
  static constexpr double stalled_current = 9;
  static constexpr double shorted_current = 20;

  void set_damage(ActuatorDamage damage, bool is_there) { damages_[static_cast<std::size_t>(damage)] = is_there; }
  void step(bool extend, bool retract, Time dt);

  double position() const;                          // 0 = retracted, 1 = extended; in the middle at first
  double current(bool extend, bool retract) const;  // A, with these outputs, where it is now

 private:
  bool has(ActuatorDamage damage) const { return damages_[static_cast<std::size_t>(damage)]; }
  bool is_at_end(bool extend) const { return extended_ == (extend ? stroke : Time{}); }
  bool moves() const {
    return !has(ActuatorDamage::open) && !has(ActuatorDamage::shorted) && !has(ActuatorDamage::blocked);
  }

  Time extended_ = stroke / 2;  // so much running from the retracted end
  std::array<bool, 4> damages_{};
};

}  // namespace simulation
