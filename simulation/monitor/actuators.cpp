#include "simulation/monitor/actuators.hpp"

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

// SB-00.7: mode 1 is the first actuator, 2 the second, 3 both.
bool includes(int mode, std::size_t actuator) {
  return mode <= 3 && (mode >> actuator & 1) != 0;
}

}  // namespace

void Actuators::take(const Joystick& stick) {
  const int off = stick.speed - limits::neutral_reading;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const bool is_its_way = i % 2 == 0 ? off > limits::deadband : off < -limits::deadband;
    if (includes(stick.mode, i / 2) && is_its_way) {
      outputs_[i].asked = stick.end;
    }
  }
}

void Actuators::report(const SpmGeneral& packet, Time at) {
  for (std::size_t i = 0; i < told_off_.size(); ++i) {
    const bool is_allowed = packet.is_actuator_mode() && includes(packet.mode, i);
    told_off_[i] = is_allowed ? std::optional<Time>() : told_off_[i].value_or(at);
  }
}

void Actuators::advance(const Pins& pins, Time now) {
  now_ = now;
  const std::array<bool, 4> levels = {pins.actuator1_extend, pins.actuator1_retract, pins.actuator2_extend,
                                      pins.actuator2_retract};
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    Output& output = outputs_[i];
    output.has_begun = levels[i] && !output.is_on;
    output.is_on = levels[i];
    output.began = output.has_begun ? now : output.began;
    output.last = output.is_on ? now : output.last;
  }
  (is_on() ? on_at_ : off_at_) = now;
}

bool Actuators::is_on() const {
  return std::any_of(outputs_.begin(), outputs_.end(), [](const Output& output) { return output.is_on; });
}

bool Actuators::has_begun() const {
  return std::any_of(outputs_.begin(), outputs_.end(), [](const Output& output) { return output.has_begun; });
}

bool Actuators::goes_both_ways() const {
  return (outputs_[0].is_on && outputs_[1].is_on) || (outputs_[2].is_on && outputs_[3].is_on);
}

bool Actuators::is_unasked() const {
  return std::any_of(outputs_.begin(), outputs_.end(), [&](const Output& output) {
    return output.is_on && !(output.asked && now_ - *output.asked <= limits::actuators_off);
  });
}

bool Actuators::is_outside_its_mode() const {
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const auto& off = told_off_[i / 2];
    if (outputs_[i].is_on && off && now_ - *off > limits::turn) {
      return true;
    }
  }
  return false;
}

bool Actuators::turns_round_too_soon() const {
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const auto& other = outputs_[i ^ 1].last;
    if (outputs_[i].has_begun && other && now_ - *other < limits::actuator_pause) {
      return true;
    }
  }
  return false;
}

bool Actuators::is_on_too_long() const {
  return std::any_of(outputs_.begin(), outputs_.end(), [&](const Output& output) {
    return output.is_on && now_ - output.began > limits::actuator_longest;
  });
}

}  // namespace simulation::monitor
