#include "simulation/monitor/lamps.hpp"

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {

void Lamps::begin_anew(Time now) {
  *this = Lamps();
  now_ = lit_at_ = dark_at_ = now;
  for (Lamp& lamp : lamps_) {
    lamp.unasked = now;
  }
}

void Lamps::take(const SrGeneral& packet) {
  const std::array<bool, 3> asked = {packet.left || packet.hazard, packet.right || packet.hazard, packet.headlight};
  for (std::size_t i = 0; i < lamps_.size(); ++i) {
    if (asked[i]) {
      lamps_[i].unasked = std::nullopt;
    } else if (!packet.is_doubtful) {
      lamps_[i].unasked = lamps_[i].unasked.value_or(packet.end);
    }
  }
}

void Lamps::advance(const Pins& pins, Time now) {
  now_ = now;
  lamps_[0].is_lit = pins.left_indicator;
  lamps_[1].is_lit = pins.right_indicator;
  lamps_[2].is_lit = pins.headlight;
  (lamps_[0].is_lit || lamps_[1].is_lit ? lit_at_ : dark_at_) = now;
}

bool Lamps::is_lit() const {
  return std::any_of(lamps_.begin(), lamps_.end(), [](const Lamp& lamp) { return lamp.is_lit; });
}

bool Lamps::is_unasked() const {
  return std::any_of(lamps_.begin(), lamps_.end(), [&](const Lamp& lamp) {
    return lamp.is_lit && lamp.unasked && now_ - *lamp.unasked > limits::lamps_off;
  });
}

bool Lamps::are_indicators_steadily_lit() const {
  return now_ - dark_at_ > limits::turn;
}

bool Lamps::are_indicators_steadily_dark() const {
  return now_ - lit_at_ > limits::turn;
}

}  // namespace simulation::monitor
