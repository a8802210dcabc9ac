#include "spm/motion.hpp"

#include "spm/limits.hpp"

namespace spm {

void Motion::configure(const Settings& settings) {
  profile_ = make_profile(settings);
  brake_times_.release = base::Millis(settings[Setting::brake_release_time]);
  brake_times_.engage = base::Millis(settings[Setting::brake_engage_time]);
  brake_times_.stopped = limits::stopped_brake_delay;
}

// Not inlined: in the loop's one big function it has no registers left.
__attribute__((noinline)) void Motion::step(const Leave& leave, base::Instant now) {
  if (is_command_stale_ || leave.is_limping != was_limping_) {
    command_ = command_of(stick_, profile_, leave.is_limping);
    ramps_.aim_at(command_);
    speedo_ = speedo_of(granted_, profile_);
    is_command_stale_ = false;
    was_limping_ = leave.is_limping;
  }

  if (leave.must_cut) {
    park_brake_.engage();
  }
  if (!park_brake_.allows_torque()) {
    ramps_.clear();
  } else if (leave.may_drive) {
    ramps_.step(profile_);
  } else {
    ramps_.stop(profile_);  // SB-2.17
  }

  GateFacts facts;
  facts.may_drive = leave.may_drive;
  facts.allows_torque = park_brake_.allows_torque();
  facts.is_limping = leave.is_limping;
  facts.general_age = leave.general_age;
  const Wheels asked = ramps_.demand();
  granted_ = gate_.pass(asked, facts);
  if (granted_ != asked) {
    ramps_.yield_to(granted_);  // H-33: nothing to catch up with later
  }
  if (granted_.is_zero()) {
    speedo_ = 0;
  }

  park_brake_.step(brake_times_, leave.may_drive && !command_.is_zero(), leave.may_drive, granted_.is_zero(), now);
}

}  // namespace spm
