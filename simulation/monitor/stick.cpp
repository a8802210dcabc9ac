#include "simulation/monitor/stick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {

void Stick::take(const Joystick& packet) {
  general_ = packet;
  forward_.point(packet.speed, packet.is_doubtful);
  turn_.point(packet.direction, packet.is_doubtful);
  if (!packet.is_neutral() || packet.is_doubtful) {
    neutral_since_ = std::nullopt;
  } else if (!neutral_since_) {
    neutral_since_ = packet.end;
    is_release_new_ = true;
  }
}

void Stick::advance(const Wheels& wheels) {
  forward_.follow(wheels.left() + wheels.right(), wheels.is_relieved());
  turn_.follow(wheels.left() - wheels.right(), wheels.is_relieved());
  if (is_release_new_) {
    duty_at_release_ = std::max(wheels.largest(), wheels.largest_before());
    is_release_new_ = false;
  }
}

void Stick::Axis::point(int reading, bool is_doubtful) {
  const int off = reading - limits::neutral_reading;
  const int points_to = std::abs(off) <= limits::deadband || is_doubtful ? 0 : off > 0 ? 1 : -1;
  if (points_to != side) {
    side = points_to;
    best = std::nullopt;
    against = 0;
  }
}

// Until the duties have come round to the stick's side they may only come nearer.
void Stick::Axis::follow(int duties, bool is_relieved) {
  const int along = std::min(side * duties, 0);
  if (is_relieved) {  // H-31: one wheel was cut
    best = along;
  }
  best = std::max(along, best.value_or(along));
  against = *best - along;
}

std::string Stick::tell(Time now) const {
  if (!general_) {
    return "no general yet";
  }
  return fmt::format("general {:.1f} ms ago, speed {}, direction {}, mode {}", milliseconds(now - general_->end),
                     general_->speed, general_->direction, general_->mode);
}

}  // namespace simulation::monitor
