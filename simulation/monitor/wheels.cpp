#include "simulation/monitor/wheels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

constexpr double steps_a_nanosecond = static_cast<double>(limits::full_duty) / limits::steepest.count();
constexpr double most_credit = steps_a_nanosecond * limits::held_up.count() + 1;

constexpr Time sample_period = 1ms;

int signed_duty(std::uint16_t duty, bool is_forward) {
  return is_forward ? duty : -duty;
}

int count_on(bool is_so, int count) {
  return is_so ? count + 1 : 0;
}

}  // namespace

void Wheels::Wheel::begin_anew() {
  now = before = 0;
  rise_credit = fall_credit = most_credit;
}

void Wheels::Wheel::take(int duty, double current, Time passed, bool is_cut) {
  before = now;
  now = duty;
  weigh(current, passed);
  const double allowed = steps_a_nanosecond * static_cast<double>(passed.count());
  rise_credit = std::min(most_credit, std::max(0.0, rise_credit) + allowed);
  fall_credit = std::min(most_credit, std::max(0.0, fall_credit) + allowed);
  const int change = std::abs(now - before);
  if (has_grown()) {
    rise_credit -= change;
  } else if (!is_cut && !is_relieved()) {
    fall_credit -= change;
  }
}

void Wheels::Wheel::weigh(double current, Time passed) {
  overloaded = std::abs(current) > limits::most_amperes ? overloaded + passed : Time{};
  const bool is_driven = (current > 0 && before > 0) || (current < 0 && before < 0);
  const bool is_above = is_driven && std::abs(current) > limits::peak_amperes;
  above_peak = is_above && std::abs(current) > limits::peak_amperes_held ? above_peak + passed : Time{};
  relief = is_above ? limits::current_reaction : std::max(Time{}, relief - passed);
}

bool Wheels::Wheel::grows_above_peak() const {
  return above_peak > limits::current_reaction && has_grown();
}

// Away from zero, or through it.
bool Wheels::Wheel::has_grown() const {
  return std::abs(now) > std::abs(before) || (now < 0 && before > 0) || (now > 0 && before < 0);
}

bool Wheels::Wheel::has_flipped() const {
  const bool is_other_side = (now < 0 && before > 0) || (now > 0 && before < 0);
  return is_other_side && std::abs(now) + std::abs(before) > limits::made_up_at_once;
}

void Wheels::begin_anew(Time now) {
  *this = Wheels();
  left_.begin_anew();
  right_.begin_anew();
  at_ = before_at_ = zero_from_ = zero_at_ = still_from_ = braked_until_ = now;
}

void Wheels::take(const Pins& pins, double left_current, double right_current, Time now) {
  before_ = pins_;
  pins_ = pins;
  before_at_ = at_;
  at_ = now;
  // A sample may fall between the pins; that the brakes follow, and together, is for other clauses (H-12.3, H-12.2).
  const bool is_cut = !pins.bridge_enable && !pins.motor_relay;
  left_.take(signed_duty(pins.left_duty, pins.left_forward), left_current, at_ - before_at_, is_cut);
  right_.take(signed_duty(pins.right_duty, pins.right_forward), right_current, at_ - before_at_, is_cut);
  if (!is_zero()) {
    zero_from_ = now + sample_period;
  } else {
    zero_at_ = now;
  }
  if (!is_still()) {
    still_from_ = now + sample_period;
  }
  if (!are_both_released()) {
    braked_until_ = now;
  }
  odds_ = count_on(pins.left_brake_release != pins.right_brake_release, odds_);
  braked_torque_ = count_on(!is_zero() && !are_both_released(), braked_torque_);
  loose_ = count_on(is_a_brake_released() && !(pins.bridge_enable && pins.motor_relay), loose_);
}

int Wheels::largest() const {
  return std::max(std::abs(left_.now), std::abs(right_.now));
}

int Wheels::largest_before() const {
  return std::max(std::abs(left_.before), std::abs(right_.before));
}

bool Wheels::has_begun_to_release() const {
  return is_a_brake_released() && !before_.left_brake_release && !before_.right_brake_release;
}

std::string Wheels::tell() const {
  const auto brake = [](bool is_released) { return is_released ? "released" : "engaged"; };
  return fmt::format("duty left {} -> {}, right {} -> {} of {}; brakes {}/{}; bridge {}, relay {}, latch {}",
                     left_.before, left_.now, right_.before, right_.now, limits::full_duty,
                     brake(pins_.left_brake_release), brake(pins_.right_brake_release),
                     pins_.bridge_enable ? "on" : "off", pins_.motor_relay ? "closed" : "open",
                     pins_.power_latch ? "held" : "released");
}

}  // namespace simulation::monitor
