// When the park brakes are released and engaged, and so when there may be torque.
//
//   engaged --wants to drive--> releasing left --stagger--> releasing --release time--> released
//   released --at rest for the engage time--> engaged
//
// The left coil is switched on first, so that the one sensor tells which coil is wrong (H-13); both go off together.
// Invariants: torque only while released; engaged only while the demand is zero, but for engage().
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace spm {

class ParkBrake {
 public:
  struct Times {
    base::Millis release;  // both coils on to torque
    base::Millis engage;   // demand zero to coil off, driving allowed
    base::Millis stopped;  // demand zero to coil off, driving forbidden (SB-2.17)
  };

  // Once a millisecond. `wants_motion`: some target is not zero; `is_demand_zero`: what the wheels get now.
  void step(const Times& times, bool wants_motion, bool may_drive, bool is_demand_zero, base::Instant now);

  // At once, whatever the demand: the motors are switched off in the same step (H-10).
  void engage() { state_ = State::engaged; }

  bool is_released() const { return state_ != State::engaged; }  // a coil is on
  bool are_both_released() const { return state_ >= State::releasing; }
  bool allows_torque() const { return state_ == State::released; }

 private:
  enum class State : uint8_t { engaged, releasing_left, releasing, released };

  State state_ = State::engaged;
  base::Instant since_;  // releasing: the newer coil on; released: the last moment the chair was not at rest
};

}  // namespace spm
