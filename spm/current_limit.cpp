#include "spm/current_limit.hpp"

#include "spm/current_steps.hpp"
#include "spm/limits.hpp"

namespace spm {

using base::magnitude;
using base::Milliamps;

namespace {

constexpr int16_t full = full_demand.count();

constexpr int16_t peak = current_steps(limits::motor_peak);
constexpr int16_t continuous = current_steps(limits::motor_continuous);
constexpr int16_t urgent = peak + current_steps(Milliamps(2000));
constexpr int16_t shock = peak + current_steps(Milliamps(12000));
constexpr int16_t a_little = current_steps(Milliamps(1000));  // the sensor has a grain of 0.25 A

// What a winding ends at that has its continuous current for ever.
constexpr uint16_t hot = (continuous / 4) * (continuous / 4) / 4;
constexpr uint16_t warm = hot / 2;         // from here on the limit sinks
constexpr uint16_t stalls = hot / 4 * 3;   // who stands from here on is stopped
constexpr uint16_t too_hot = hot / 2 * 3;  // only braking gets it there, which the limit leaves alone
constexpr uint16_t cooled = hot / 4 * 5;
constexpr uint16_t sinking = (peak - continuous) * int32_t{256} / (hot - warm);

// 24 V and 0.15 ohm are 160 A: a step of current is 6.6 of demand. A little less is taken back for each step too much,
// so that the current does not fall far below its limit.
constexpr int16_t demand_for_a_step = 5;
// And a little more is what a motor may have that stands: it may be hot, the battery low (19 V).
constexpr int16_t standing_demand_for_a_step = 8;
constexpr int16_t gentle_cut = 128;  // in a look: 800 permille a second, as in an emergency stop

int16_t limit_at(uint16_t temperature) {
  if (temperature <= warm) {
    return peak;
  }
  if (temperature >= hot) {
    return continuous;
  }
  const uint32_t sunk = static_cast<uint32_t>(static_cast<uint16_t>(temperature - warm)) * sinking;
  return static_cast<int16_t>(peak - static_cast<int16_t>(sunk >> 8));
}

Demand nearer_zero(Demand value, int16_t most) {
  return value.count() > most ? Demand(most) : value.count() < -most ? Demand(static_cast<int16_t>(-most)) : value;
}

int16_t smaller(int16_t value, int16_t other) {
  return value < other ? value : other;
}

}  // namespace

void CurrentLimit::look(const Inputs& in, const Wheels& given, bool is_at_rest) {
  look_at(left_, in.left_current, given.left);
  look_at(right_, in.right_current, given.right);
  is_acting_ = left_.most < full || right_.most < full;
  if (is_acting_ && !left_.is_urgent && !right_.is_urgent) {
    keep_curve(given);
  }
  const bool stands = left_.standing >= limits::stall_looks || right_.standing >= limits::stall_looks;
  const uint16_t left = left_.winding.temperature();
  const uint16_t right = right_.winding.temperature();
  const uint16_t hotter = left > right ? left : right;
  is_stalled_ = stands || hotter >= too_hot || (is_stalled_ && (!is_at_rest || hotter >= cooled));  // H-31
}

void CurrentLimit::look_at(Motor& motor, Milliamps current, Demand given) {
  const int16_t signed_steps = current_steps(current);
  const int16_t steps = magnitude(signed_steps);
  motor.winding.take(steps > 1020 ? uint8_t{255} : static_cast<uint8_t>(steps >> 2));
  motor.most = full;
  motor.is_urgent = false;
  const int16_t limit = limit_at(motor.winding.temperature());
  const bool is_driven = (given > Demand(0) && signed_steps > 0) || (given < Demand(0) && signed_steps < 0);
  if (!is_driven || steps < limit - a_little) {
    motor.standing = 0;
    return;
  }
  const int16_t demand = magnitude(given.count());
  const bool stands = demand <= steps * standing_demand_for_a_step;
  if (!stands || motor.winding.temperature() < stalls) {
    motor.standing = 0;
  } else if (motor.standing < limits::stall_looks) {
    ++motor.standing;
  }
  if (steps <= limit) {
    return;
  }
  motor.is_urgent = steps > urgent;
  if (steps > shock) {  // H-10: four looks above 80 A are a stuck output
    motor.most = static_cast<int16_t>(demand >> 1);
    return;
  }
  int16_t cut = static_cast<int16_t>((steps - limit) * demand_for_a_step);
  cut = motor.is_urgent ? cut : smaller(cut, gentle_cut);
  motor.most = static_cast<int16_t>(demand > cut ? demand - cut : 0);
}

void CurrentLimit::keep_curve(const Wheels& given) {
  const int16_t left = magnitude(given.left.count());
  const int16_t right = magnitude(given.right.count());
  const int16_t most_left = left_.most;
  if (right_.most < right) {
    left_.most = smaller(left_.most, scaled(left, byte_share(right_.most, right)));
  }
  if (most_left < left) {
    right_.most = smaller(right_.most, scaled(right, byte_share(most_left, left)));
  }
}

Wheels CurrentLimit::bound(const Wheels& asked) const {
  return Wheels{nearer_zero(asked.left, left_.most), nearer_zero(asked.right, right_.most)};
}

}  // namespace spm
