// The three lamp pins, and what the remote asks of them: its requests are levels (SB-00.2).
#pragma once

#include <array>
#include <optional>

#include "simulation/monitor/general.hpp"
#include "simulation/world.hpp"

namespace simulation::monitor {

class Lamps {
 public:
  void begin_anew(Time now);
  void take(const SrGeneral& packet);
  void advance(const Pins& pins, Time now);

  bool is_lit() const;
  bool is_unasked() const;  // one is lit, and the remote's last generals have not asked for it for too long
  // An indicator, or none, at all samples for longer than a turn.
  bool are_indicators_steadily_lit() const;
  bool are_indicators_steadily_dark() const;

 private:
  struct Lamp {
    bool is_lit = false;
    std::optional<Time> unasked;
  };

  std::array<Lamp, 3> lamps_{};  // left, right, headlight
  Time now_{};
  Time lit_at_{};  // an indicator
  Time dark_at_{};
};

}  // namespace simulation::monitor
