// Motors and brakes as their pins show them, a sample a millisecond: what grew, how fast, and since when.
#pragma once

#include <algorithm>
#include <string>

#include "simulation/world.hpp"

namespace simulation::monitor {

class Wheels {
 public:
  // No supply, or a reset: whatever is seen next begins from rest.
  void begin_anew(Time now);
  // Currents in amperes, forward positive.
  void take(const Pins& pins, double left_current, double right_current, Time now);

  const Pins& pins() const { return pins_; }
  Time at() const { return at_; }
  Time before_at() const { return before_at_; }
  int left() const { return left_.now; }  // forward positive
  int right() const { return right_.now; }
  int largest() const;
  int largest_before() const;

  bool is_zero() const { return left_.now == 0 && right_.now == 0; }
  bool was_zero() const { return left_.before == 0 && right_.before == 0; }
  bool has_grown() const { return left_.has_grown() || right_.has_grown(); }  // since the sample before
  bool has_flipped() const { return left_.has_flipped() || right_.has_flipped(); }
  bool rises_too_fast() const { return left_.rise_credit < 0 || right_.rise_credit < 0; }
  bool falls_too_fast() const { return left_.fall_credit < 0 || right_.fall_credit < 0; }

  // H-31: one of them, for longer than that.
  bool is_overloaded_for(Time span) const { return std::max(left_.overloaded, right_.overloaded) > span; }
  bool grows_above_peak() const { return left_.grows_above_peak() || right_.grows_above_peak(); }
  // A motor draws, or drew a moment ago, more than its peak: then its duty may fall at once, and the chair turn.
  bool is_relieved() const { return left_.is_relieved() || right_.is_relieved(); }

  bool is_a_brake_released() const { return pins_.left_brake_release || pins_.right_brake_release; }
  bool are_both_released() const { return pins_.left_brake_release && pins_.right_brake_release; }
  bool has_begun_to_release() const;
  bool is_still() const { return is_zero() && !is_a_brake_released(); }
  // Since the first sample that showed it; negative if none does.
  Time still_for() const { return at_ - still_from_; }
  Time zero_for() const { return at_ - zero_from_; }
  Time busy_for() const { return at_ - zero_at_; }  // a duty, since the last sample that showed none
  // Both, since the last sample that showed one engaged.
  Time released_for() const { return at_ - braked_until_; }
  // Two samples in a row: longer than the order of writing pins explains.
  bool are_brakes_at_odds() const { return odds_ > 1; }
  bool is_braked_torque() const { return braked_torque_ > 1; }
  bool is_loose_brake() const { return loose_ > 1; }  // released without bridge and relay

  std::string tell() const;

 private:
  struct Wheel {
    int now = 0;
    int before = 0;
    double rise_credit = 0;  // steps that may still be made, as of the steepest ramp
    double fall_credit = 0;

    void begin_anew();
    Time overloaded{};  // since when there is more current than any motor stands
    Time above_peak{};  // since when the motor is driven with more than its peak
    Time relief{};      // still to come, since it was

    void take(int duty, double current, Time passed, bool is_cut);
    void weigh(double current, Time passed);
    bool has_grown() const;
    bool grows_above_peak() const;
    bool is_relieved() const { return relief > Time{}; }
    bool has_flipped() const;
  };

  Wheel left_;
  Wheel right_;
  Pins pins_;
  Pins before_;
  Time at_{};
  Time before_at_{};
  Time zero_from_{};
  Time zero_at_{};
  Time still_from_{};
  Time braked_until_{};
  int odds_ = 0;  // samples in a row
  int braked_torque_ = 0;
  int loose_ = 0;
};

}  // namespace simulation::monitor
