// The four actuator pins: since when each is on, and when a stick last asked for it (H-18).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "simulation/monitor/general.hpp"
#include "simulation/world.hpp"

namespace simulation::monitor {

class Actuators {
 public:
  void begin_anew() { *this = Actuators(); }
  // A general of the module that drives, or may.
  void take(const Joystick& stick);
  void report(const SpmGeneral& packet, Time at);
  void advance(const Pins& pins, Time now);

  bool is_on() const;
  bool has_begun() const;  // one of them, with the last sample
  bool goes_both_ways() const;
  bool is_unasked() const;           // on, and no stick has asked for it for too long
  bool is_outside_its_mode() const;  // on, and its mode is not told, or as invalid, for longer than a turn
  bool turns_round_too_soon() const;
  bool is_on_too_long() const;
  Time busy_for() const { return now_ - off_at_; }
  Time on_at() const { return on_at_; }  // one of them, the last sample that showed it

 private:
  struct Output {
    bool is_on = false;
    bool has_begun = false;
    Time began{};
    std::optional<Time> last;  // on
    std::optional<Time> asked;
  };

  // Extend and retract of the first, then of the second.
  std::array<Output, 4> outputs_{};
  std::array<std::optional<Time>, 2> told_off_{};  // since when no report allows this actuator
  Time now_{};
  Time on_at_ = Time(-1s);
  Time off_at_{};  // all, the last sample
};

}  // namespace simulation::monitor
