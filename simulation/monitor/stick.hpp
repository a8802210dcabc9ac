// What the driver asks for, as the generals tell it: which way, since when, and whether the wheels follow (H-03, H-11).
#pragma once

#include <optional>
#include <string>

#include "simulation/monitor/general.hpp"
#include "simulation/monitor/wheels.hpp"

namespace simulation::monitor {

class Stick {
 public:
  void begin_anew() { *this = Stick(); }
  // A general of the module that drives.
  void take(const Joystick& packet);
  void advance(const Wheels& wheels);

  const std::optional<Joystick>& general() const { return general_; }  // the last
  // Since the first of the neutral ones up to now; only where it is certain.
  std::optional<Time> neutral_since() const { return neutral_since_; }
  // The largest duty when it became neutral.
  int duty_at_release() const { return duty_at_release_; }
  // So many steps of a duty the chair has gone away from where an axis points, since it points there.
  int drives_against() const { return forward_.against; }
  int turns_against() const { return turn_.against; }
  std::string tell(Time now) const;

 private:
  // One axis and the sum or difference of the duties it commands.
  struct Axis {
    int side = 0;  // -1, 0 neutral or unknown, 1
    std::optional<int> best;
    int against = 0;

    void point(int reading, bool is_doubtful);
    void follow(int duties, bool is_relieved);
  };

  std::optional<Joystick> general_;
  std::optional<Time> neutral_since_;
  bool is_release_new_ = false;
  int duty_at_release_ = 0;
  Axis forward_;
  Axis turn_;
};

}  // namespace simulation::monitor
