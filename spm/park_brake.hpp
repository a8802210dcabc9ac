// When the park brakes are released and engaged, and so when there may be torque.
//
//   engaged --wants to drive--> releasing --release time, coils seen on--> released --at rest for the engage time-->
//   engaged
//
// Invariants: torque only while released; engaged only while the demand is zero, but for engage(); no flipped bit makes
// one state of another (H-27).
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace spm {

class ParkBrake {
 public:
  struct Times {
    base::Millis release;  // coil on to torque
    base::Millis engage;   // demand zero to coil off, driving allowed
    base::Millis stopped;  // demand zero to coil off, driving forbidden (SB-2.17)
  };

  struct Facts {
    bool wants_motion = false;   // some target is not zero
    bool may_drive = false;      // no reason against it
    bool may_release = false;    // the outputs have passed their test
    bool are_coils_on = false;   // seen, not only said
    bool is_demand_zero = true;  // what the wheels get now
  };

  // Once a millisecond.
  void step(const Times& times, const Facts& facts, base::Instant now);

  // At once, whatever the demand: the motors are switched off in the same step (H-10).
  void engage() { state_ = State::engaged; }

  bool is_released() const { return state_ != State::engaged; }  // the coils are on
  bool allows_torque() const { return state_ != State::engaged && state_ != State::releasing; }
  // A bit of the state had flipped; step() chose the one that fits the demand.
  bool has_mended() const { return has_mended_; }

 private:
  // Any two differ in four bits at least.
  enum class State : uint8_t { engaged = 0x0F, releasing = 0x33, released = 0xFC };

  State state_ = State::engaged;
  bool has_mended_ = false;
  base::Instant since_;  // releasing: coil on; released: the last moment the chair was not at rest
};

}  // namespace spm
