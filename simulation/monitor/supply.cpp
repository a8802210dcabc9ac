#include "simulation/monitor/supply.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {

void Supply::begin_anew(Time now) {
  *this = Supply();
  began_ = heard_ = possibly_heard_ = active_ = still_since_ = now;
}

void Supply::heard(Time at, bool is_doubtful) {
  possibly_heard_ = at;
  if (!is_doubtful) {
    heard_ = at;
  }
}

void Supply::general(const SrGeneral& packet, bool drives) {
  heard(packet.end, packet.is_doubtful);
  if (packet.power_switch || (drives && !packet.is_neutral())) {
    active_ = packet.end;
  }
  if (!packet.power_switch) {
    may_ask_ = may_ask_ || is_press_possible_;  // SB-4.1: not before the release
    is_press_possible_ = false;
    button_ = Button::up;
  } else if (button_ == Button::up) {
    button_ = Button::down;
    pressed_ = packet.end;
  } else if (button_ == Button::down) {
    const Time held = packet.end - pressed_;
    is_press_possible_ = is_press_possible_ || held >= limits::press_possible;
    if (held >= limits::press_certain && !packet.is_doubtful && !accepted_) {
      accepted_ = packet.end;
    }
  }
  confirms_ = packet.confirm && asked_ ? confirms_ + 1 : 0;  // SB-4.3
  if (confirms_ >= limits::confirms && !confirmed_) {
    confirmed_ = packet.end;
  }
}

void Supply::report(const SpmGeneral& packet, Time at) {
  const Time possibly_since = has_reported_ ? at - limits::turn : began_;
  locked_ = packet.locked ? locked_.value_or(possibly_since) : std::optional<Time>();
  has_reported_ = true;
  if (packet.power_down_now && !asked_) {
    asked_ = heard_;
  }
}

void Supply::advance(Time now, bool is_latched, bool is_still) {
  has_let_go_ = is_latched_ && !is_latched;
  is_latched_ = is_latched;
  was_ever_latched_ = was_ever_latched_ || is_latched;
  if (!is_still) {
    still_since_ = now;
  }
}

bool Supply::may_sleep(Time now) const {
  return now - active_ >= limits::sleep;
}

bool Supply::may_let_go(Time now) const {
  const Time silence = now - heard_;
  if (!has_spoken_ && now - began_ >= limits::lost_least) {  // a chip that has failed its self-test hears nobody
    return true;
  }
  return confirmed_ || silence >= limits::lost_least || (asked_ && silence >= limits::unconfirmed_least);
}

bool Supply::is_over(Time since, Time span, Time now) const {
  return now - std::max(since, still_since_) > span;
}

bool Supply::is_overdue_after_confirm(Time now) const {
  return is_latched_ && confirmed_ && is_over(*confirmed_, limits::power_down, now);
}

bool Supply::is_overdue_after_silence(Time now) const {
  const Time limit = asked_ ? limits::unconfirmed_most : limits::lost_most;
  const Time margin = 20ms;  // for a stop that ends just then
  return is_latched_ && now - possibly_heard_ > limit && now - still_since_ > margin;
}

std::string Supply::tell(Time now) const {
  std::string text = fmt::format("remote heard {:.1f} ms ago", milliseconds(now - heard_));
  text += asked_ ? ", power-down asked for" : "";
  text += confirmed_ ? ", confirmed" : confirms_ > 0 ? ", confirmed once" : "";
  return text;
}

}  // namespace simulation::monitor
