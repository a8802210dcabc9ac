#include "spm/park_brake.hpp"

namespace spm {

void ParkBrake::step(const Times& times, bool wants_motion, bool may_drive, bool is_demand_zero, base::Instant now) {
  switch (state_) {
    case State::engaged:
      if (wants_motion && may_drive) {
        state_ = State::releasing;
        since_ = now;
      }
      break;
    case State::releasing:
      if (!may_drive) {
        state_ = State::engaged;
      } else if (now - since_ >= times.release) {
        state_ = State::released;
        since_ = now;
      }
      break;
    case State::released:
      if (!is_demand_zero || (wants_motion && may_drive)) {
        since_ = now;
      } else if (now - since_ >= (may_drive ? times.engage : times.stopped)) {
        state_ = State::engaged;
      }
      break;
    default:  // H-27
      has_mended_ = true;
      since_ = now;
      state_ = is_demand_zero ? State::engaged : State::released;
  }
}

}  // namespace spm
