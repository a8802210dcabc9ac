#include "spm/motion.hpp"

#include "spm/limits.hpp"

namespace spm {

namespace {

// H-26: two thirds of it while braking feeds a battery that is full, and never slower than the slowest. Emergency stops
// have a rate of their own, whatever the voltage.
uint16_t braking_rate(uint16_t own, bool is_over_voltage) {
  if (!is_over_voltage || own <= limits::gentlest_braking) {
    return own;
  }
  const uint16_t gentle = static_cast<uint16_t>(own - own / 3);
  return gentle > limits::gentlest_braking ? gentle : limits::gentlest_braking;
}

// What yielding to the gate may leave over.
constexpr uint8_t most_left_over = 2;

bool are_near(Demand one, Demand other) {
  const uint16_t apart =
      static_cast<uint16_t>(static_cast<uint16_t>(one.count()) - static_cast<uint16_t>(other.count()));
  return static_cast<uint16_t>(apart + most_left_over) <= 2 * most_left_over;
}

bool are_near(const Wheels& some, const Wheels& others) {
  return are_near(some.left, others.left) && are_near(some.right, others.right);
}

template <typename Some>
uint16_t sum_of_bytes(const Some& some) {
  uint16_t sum = 0;
  const uint8_t* byte = reinterpret_cast<const uint8_t*>(&some);
  for (uint8_t i = 0; i < sizeof some; ++i) {
    sum = static_cast<uint16_t>(sum + byte[i]);
  }
  return sum;
}

}  // namespace

void Motion::configure(const Settings& settings) {
  profile_ = make_profile(settings);
  own_ = {profile_.acceleration, profile_.forward_deceleration, profile_.reverse_deceleration};
  is_battery_low_ = is_over_voltage_ = false;  // until spare_battery() says so again
  brake_times_.release = base::Millis(settings[Setting::brake_release_time]);
  brake_times_.engage = base::Millis(settings[Setting::brake_engage_time]);
  brake_times_.stopped = limits::stopped_brake_delay;
  configuration_sum_ = sum_of_configuration();
}

uint16_t Motion::sum_of_configuration() const {
  return static_cast<uint16_t>(sum_of_bytes(profile_) + sum_of_bytes(own_) + sum_of_bytes(brake_times_));
}

// H-27: gate, ramps and this object each remember the demand of the millisecond before; two of them are believed.
void Motion::mend() {
  const Wheels& kept = gate_.last();
  const Wheels ramped = ramps_.demand();
  if (ramped == kept || are_near(ramped, kept)) {
    return;
  }
  has_mended_ = true;
  if (kept == granted_) {
    ramps_.resume(granted_);
  } else {
    gate_.remember(granted_);
  }
}

void Motion::watch(const Inputs& in) {
  if (in.analog_ready) {
    current_limit_.look(in, granted_, mix(ramps_.target()), is_stick_at_rest() && !park_brake_.is_released());
  }
}

__attribute__((noinline)) void Motion::spare_battery(Demand most, bool is_over_voltage) {
  most_ = most;
  const bool is_low = most < full_demand;
  if (is_low == is_battery_low_ && is_over_voltage == is_over_voltage_) {
    return;
  }
  is_battery_low_ = is_low;
  is_over_voltage_ = is_over_voltage;
  const bool was_intact = is_configuration_intact();
  profile_.acceleration = is_low ? static_cast<uint16_t>(own_.acceleration / 2) : own_.acceleration;
  profile_.forward_deceleration = braking_rate(own_.forward_deceleration, is_over_voltage);
  profile_.reverse_deceleration = braking_rate(own_.reverse_deceleration, is_over_voltage);
  if (was_intact) {  // H-27: what was not stays so
    configuration_sum_ = sum_of_configuration();
  }
}

// Not inlined: in the loop's one big function it has no registers left.
__attribute__((noinline)) void Motion::step(const Leave& leave, base::Instant now) {
  mend();
  if (is_command_stale_ || leave.is_limping != was_limping_) {
    command_ = command_of(stick_, profile_, leave.is_limping, most_);
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

  const Wheels asked = ramps_.demand();
  granted_ = gate_.pass(current_limit_.is_acting() ? current_limit_.bound(asked) : asked,  // H-31
                        GateFacts{leave.may_drive, park_brake_.allows_torque(), leave.is_limping, leave.general_age});
  if (granted_ != asked) {
    ramps_.yield_to(granted_);  // H-33: nothing to catch up with later
  }
  if (granted_.is_zero()) {
    speedo_ = 0;
  }

  // Both remember what was asked for, so that no flipped bit opens the brakes (H-27).
  const bool wants_motion = !command_.is_zero() && (park_brake_.is_released() || !ramps_.target().is_zero());
  park_brake_.step(
      brake_times_,
      ParkBrake::Facts{wants_motion, gate_.has_leave(), leave.may_release, leave.are_coils_on, granted_.is_zero()},
      now);
}

}  // namespace spm
