#include "spm/current_limit.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::magnitude;
using base::Milliamps;

namespace {

constexpr int16_t unlimited = full_demand.count();

// Steps of 256 mA, about the grain of the sensors: on the AVR the upper bytes of a number, and its square fits 16 bits.
constexpr int16_t steps_of(Milliamps size) {
  return static_cast<int16_t>(size.count() / 256);
}
constexpr int16_t peak = steps_of(limits::motor_peak);
constexpr int16_t continuous = steps_of(limits::motor_continuous);
constexpr int16_t urgent = peak + steps_of(Milliamps(2048));
constexpr int16_t shock = peak + steps_of(Milliamps(12000));
constexpr int16_t a_little = 4;
constexpr int16_t most_steps = 511;  // more than the sensors can say

// What a winding ends at that has its continuous current for ever.
constexpr uint16_t hot = continuous * continuous / 16;
constexpr uint16_t warm = hot / 2;         // from here on the limit sinks
constexpr uint16_t stalls = hot / 4 * 3;   // who stands from here on is stopped
constexpr uint16_t too_hot = hot / 2 * 3;  // only braking gets it there, which the limit leaves alone
constexpr uint16_t cooled = hot / 4 * 5;
constexpr uint16_t sinking = (peak - continuous) * int32_t{256} / (hot - warm);

// 24 V and 0.15 ohm are 160 A: a step of current is 26 of demand. A little less is taken back for each step too much,
// so that the current does not fall far below its limit.
constexpr int16_t demand_for_a_step = 20;
// And a little more is what a motor may have that stands: it may be hot, the battery low (19 V).
constexpr int16_t standing_demand_for_a_step = 32;
constexpr int16_t gentle_cut = 128;  // in a look: 800 permille a second, as in an emergency stop

int16_t limit_at(uint16_t temperature) {
  if (temperature <= warm) {
    return peak;
  }
  if (temperature >= hot) {
    return continuous;
  }
  const uint16_t sunk = static_cast<uint16_t>((temperature - warm) * sinking);
  return static_cast<int16_t>(peak - static_cast<int16_t>(sunk >> 8));
}
static_assert((hot - warm) * uint32_t{sinking} <= UINT16_MAX, "what the limit sinks fits");
static_assert(most_steps * int32_t{standing_demand_for_a_step} <= INT16_MAX, "a standing demand fits");

// A negative one is no limit that was ever set (H-27).
Demand nearer_zero(Demand value, int16_t limit) {
  const int16_t most = limit < 0 ? int16_t{0} : limit;
  return value.count() > most ? Demand(most) : value.count() < -most ? Demand(static_cast<int16_t>(-most)) : value;
}

int16_t lesser(int16_t value, int16_t other) {
  return value < other ? value : other;
}

}  // namespace

// Not inlined: what is done seldom must not cost the loop's big functions registers.
__attribute__((noinline)) void CurrentLimit::look(const Inputs& in, const Wheels& given, const Wheels& wanted,
                                                  bool is_at_rest) {
  turn_ = static_cast<uint8_t>((turn_ + 1) & 3);
  look_at(left_, in.left_current, given.left, wanted.left, turn_ == 0);
  look_at(right_, in.right_current, given.right, wanted.right, turn_ == 2);
  is_acting_ = left_.most < unlimited || right_.most < unlimited;
  if (is_acting_ && !left_.is_urgent && !right_.is_urgent) {
    keep_curve(given);
  }
  const bool stands = left_.standing >= limits::stall_looks || right_.standing >= limits::stall_looks;
  const uint16_t left = left_.winding.temperature();
  const uint16_t right = right_.winding.temperature();
  const uint16_t hotter = left > right ? left : right;
  is_stalled_ = stands || hotter >= too_hot || (is_stalled_ && (!is_at_rest || hotter >= cooled));  // H-31
}

void CurrentLimit::look_at(Motor& motor, Milliamps current, Demand given, Demand wanted, bool is_taken) {
  const bool is_forward = current >= Milliamps(0);
  const uint32_t size = static_cast<uint32_t>(is_forward ? current.count() : -current.count()) >> 8;
  const int16_t steps = size > uint16_t{most_steps} ? most_steps : static_cast<int16_t>(size);
  if (is_taken) {
    motor.winding.take(steps > 255 ? uint8_t{255} : static_cast<uint8_t>(steps));
  }
  motor.most = unlimited;
  motor.is_urgent = false;
  const int16_t limit = limit_at(motor.winding.temperature());
  const int16_t demand = magnitude(given.count());
  // It pushes to where the driver wants to go, and does not get there: it stands, or is pushed back, when its own
  // voltage makes a current that leaves nothing to be given.
  const bool pushes = (is_forward ? wanted > Demand(0) : wanted < Demand(0)) && steps >= limit - a_little;
  const bool stands = pushes && demand <= steps * standing_demand_for_a_step && motor.winding.temperature() >= stalls;
  if (stands && motor.standing < limits::stall_looks) {
    ++motor.standing;
  } else if (!stands && motor.standing > 0) {
    --motor.standing;
  }
  const bool is_driven = is_forward ? given > Demand(0) : given < Demand(0);
  if (!is_driven || steps <= limit) {
    return;
  }
  motor.is_urgent = steps > urgent;
  if (steps > shock) {  // H-10: four looks above 80 A are a stuck output
    motor.most = static_cast<int16_t>(demand >> 1);
    return;
  }
  int16_t cut = static_cast<int16_t>((steps - limit) * demand_for_a_step);
  cut = motor.is_urgent ? cut : lesser(cut, gentle_cut);
  motor.most = static_cast<int16_t>(demand > cut ? demand - cut : 0);
}

void CurrentLimit::keep_curve(const Wheels& given) {
  const int16_t left = magnitude(given.left.count());
  const int16_t right = magnitude(given.right.count());
  const int16_t most_left = left_.most;
  if (right_.most < right) {
    left_.most = lesser(left_.most, scaled(left, byte_share(right_.most, right)));
  }
  if (most_left < left) {
    right_.most = lesser(right_.most, scaled(right, byte_share(most_left, left)));
  }
}

Wheels CurrentLimit::bound(const Wheels& asked) const {
  return Wheels{nearer_zero(asked.left, left_.most), nearer_zero(asked.right, right_.most)};
}

}  // namespace spm
