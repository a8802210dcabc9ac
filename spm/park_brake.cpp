#include "spm/park_brake.hpp"

namespace spm {

void ParkBrake::step(const Times& times, const Facts& facts, base::Instant now) {
  switch (state_) {
    case State::engaged:
      if (facts.wants_motion && facts.may_drive && facts.may_release) {  // H-10
        state_ = State::releasing;
        since_ = now;
      }
      break;
    case State::releasing:
      if (!facts.may_drive) {
        state_ = State::engaged;
      } else if (facts.are_coils_on && now - since_ >= times.release) {
        state_ = State::released;
        since_ = now;
      }
      break;
    case State::released:
      if (!facts.is_demand_zero || (facts.wants_motion && facts.may_drive)) {
        since_ = now;
      } else if (now - since_ >= (facts.may_drive ? times.engage : times.stopped)) {
        state_ = State::engaged;
      }
      break;
    default:  // H-27
      has_mended_ = true;
      since_ = now;
      state_ = facts.is_demand_zero ? State::engaged : State::released;
  }
}

}  // namespace spm
