// Why the power module may, or must, let its power latch go: the button and its confirmation, sleep, or a remote that
// is gone (section 4 of the document).
#pragma once

#include <optional>
#include <string>

#include "simulation/monitor/general.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {

class Supply {
 public:
  void begin_anew(Time now);
  // The remote's; its stick is the driver's for certain, or not.
  void general(const SrGeneral& packet, bool drives);
  // The attendant control's, which drives.
  void driver_acted(Time at) { active_ = at; }
  void report(const SpmGeneral& packet, Time at);  // of the power module
  // A character of the power module: it lives.
  void spoke() { has_spoken_ = true; }
  // Any packet of the remote that keeps the power on.
  void heard(Time at, bool is_doubtful);
  // Each millisecond; `is_still`: no duty, brakes engaged.
  void advance(Time now, bool is_latched, bool is_still);

  // From the press on; certain, or possible for a clock that is a millisecond off.
  std::optional<Time> button_accepted() const { return accepted_; }
  bool may_ask() const { return may_ask_; }  // "power down now"
  bool may_sleep(Time now) const;            // nobody has driven or pressed for long enough (SB-4.2)
  bool may_give_up_lock(Time now) const { return locked_ && now - *locked_ >= limits::lock_gives_up; }
  bool is_confirmed() const { return confirmed_.has_value(); }

  // With this sample the latch was let go; and there was a reason.
  bool has_let_go() const { return has_let_go_; }
  bool may_let_go(Time now) const;
  // There has been a reason, and rest, for too long.
  bool is_overdue_after_confirm(Time now) const;
  bool is_overdue_after_silence(Time now) const;
  bool is_latched() const { return is_latched_; }
  bool was_latched() const { return was_ever_latched_; }
  Time powered_for(Time now) const { return now - began_; }
  std::string tell(Time now) const;

 private:
  enum class Button : std::uint8_t { unseen, up, down };

  bool is_over(Time since, Time span, Time now) const;

  Time began_{};
  Time heard_{};  // certainly
  Time possibly_heard_{};
  Time active_{};  // the driver did something
  Time still_since_{};
  Time pressed_{};
  Button button_ = Button::unseen;
  std::optional<Time> locked_;  // it has told so since
  std::optional<Time> accepted_;
  std::optional<Time> asked_;      // the power module said "power down now"
  std::optional<Time> confirmed_;  // the second time in a row
  int confirms_ = 0;
  bool is_press_possible_ = false;
  bool may_ask_ = false;
  bool is_latched_ = false;
  bool was_ever_latched_ = false;
  bool has_let_go_ = false;
  bool has_reported_ = false;
  bool has_spoken_ = false;  // since power or reset
};

}  // namespace simulation::monitor
