#include "simulation/report/stops.hpp"

#include <algorithm>
#include <cmath>

namespace simulation::report {
namespace {

constexpr double standstill = 0.01;  // m/s

}  // namespace

void Stops::on_cause(const std::string& cause, Time at) {
  const bool is_moving = std::abs(facts_.speed()) > standstill;
  if (!is_moving || phase_ == Phase::slowing) {
    return;
  }
  current_ = Stop{};
  current_.cause = cause;
  current_.at = at;
  current_.speed = std::abs(facts_.speed());
  from_ = facts_.position();
  duty_ = facts_.largest_duty();
  phase_ = Phase::waiting;
}

void Stops::on_sample(const Sample& sample) {
  const double duty = facts_.largest_duty();
  switch (phase_) {
    case Phase::none:
      break;
    case Phase::waiting:
      if (duty < duty_) {
        begin_phase(Phase::slowing, sample);
      }
      duty_ = std::max(duty_, duty);
      break;
    case Phase::slowing:
      if (duty > duty_) {
        phase_ = Phase::none;  // it drives on: no stop
      } else if (std::abs(facts_.speed()) < standstill && !facts_.is_driven()) {
        begin_phase(Phase::still, sample);
      }
      break;
    case Phase::still:
      if (!sample.pins.left_brake_release && !sample.pins.right_brake_release) {
        all_.back().braked_after = sample.at - current_.at;
        phase_ = Phase::none;
      } else if (facts_.is_driven()) {
        phase_ = Phase::none;
      }
      break;
  }
}

void Stops::begin_phase(Phase phase, const Sample& sample) {
  phase_ = phase;
  if (phase == Phase::slowing) {
    current_.slowing_after = sample.at - current_.at;
  } else if (phase == Phase::still) {
    current_.still_after = sample.at - current_.at;
    current_.distance = std::abs(facts_.position() - from_);
    all_.push_back(current_);
  }
}

}  // namespace simulation::report
