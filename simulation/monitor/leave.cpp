#include "simulation/monitor/leave.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

constexpr std::array<const char*, reason_count> names = {"power-up phase",
                                                         "silence",
                                                         "corrupt packets",
                                                         "remote restarted",
                                                         "remote inhibit",
                                                         "charger inhibit",
                                                         "remote fault",
                                                         "calibration",
                                                         "mode",
                                                         "power button",
                                                         "neutral awaited",
                                                         "attendant control silent",
                                                         "attendant control restarted",
                                                         "attendant control's inhibit",
                                                         "attendant control's fault",
                                                         "attendant control's calibration",
                                                         "calibration is told",
                                                         "lock is told",
                                                         "handing over"};

constexpr std::size_t place_of(Reason reason) {
  return static_cast<std::size_t>(reason);
}

}  // namespace

bool is_emergency(Reason reason) {
  return reason == Reason::silence || reason == Reason::corrupt || reason == Reason::restart ||
         reason == Reason::attendant_silence || reason == Reason::attendant_restart;
}

std::string name_of(Reason reason) {
  return names[place_of(reason)];
}

void Leave::begin_anew(Time now) {
  *this = Leave();
  deny(Reason::power_up_phase, now);
}

void Leave::deny(Reason reason, Time at) {
  auto& since = since_[place_of(reason)];
  if (!since) {
    since = at;
  }
  if (!denied_since_) {
    denied_since_ = at;
    first_reason_ = reason;
  }
  if (reason != Reason::neutral && reason != Reason::mode) {  // SB-01.8; a mode when it changes
    neutral_run_ = 0;
    deny(Reason::neutral, at);
  }
  if (is_emergency(reason)) {
    const bool is_of_attendant = reason == Reason::attendant_silence || reason == Reason::attendant_restart;
    (is_of_attendant ? attendant_run_ : good_run_) = 0;
    is_stop_over_ = false;
    emergency_ = emergency_ ? emergency_ : at;
  }
}

void Leave::allow(Reason reason) {
  since_[place_of(reason)] = std::nullopt;
  if (std::none_of(since_.begin(), since_.end(), [](const auto& since) { return since.has_value(); })) {
    denied_since_ = std::nullopt;
  }
}

void Leave::put(Reason reason, bool is_set, const Joystick& packet) {
  if (!is_set) {
    allow(reason);
  } else if (!packet.is_doubtful) {
    deny(reason, packet.end);
  }
}

void Leave::put_told(Reason reason, bool is_set, Time at) {
  if (is_set) {
    deny(reason, at);
  } else {
    allow(reason);
  }
}

bool Leave::has_emergency() const {
  return since(Reason::silence) || since(Reason::corrupt) || since(Reason::restart);
}

void Leave::general(const SrGeneral& packet, Driver driver) {
  if (phase_ == Phase::silent) {  // SB-3.1
    return;
  }
  phase_ = Phase::running;
  allow(Reason::power_up_phase);
  if (is_watched_ && last_general_ && packet.end - *last_general_ > limits::silence && !packet.is_doubtful) {
    deny(Reason::silence, *last_general_ + limits::silence);
  }
  last_general_ = packet.end;
  is_watched_ = !is_resting_;
  put(Reason::remote_inhibit, packet.remote_inhibit, packet);
  put(Reason::charger_inhibit, packet.charger_inhibit, packet);
  const bool has_stick_failed = packet.joystick_error && driver == Driver::remote;
  put(Reason::remote_fault, has_stick_failed || packet.local_fault, packet);
  put(Reason::calibration, packet.calibration, packet);
  if (driver == Driver::remote) {
    request(packet);
  }
  prove();
  if (driver == Driver::remote) {
    count_neutral(packet);
  }
}

void Leave::attendant_general(const SacuGeneral& packet, Driver driver) {
  const bool drives = driver == Driver::attendant;
  if (is_attendant_watched_ && drives && packet.end - *last_of_attendant_ > limits::silence) {
    deny(Reason::attendant_silence, *last_of_attendant_ + limits::silence);
  }
  last_of_attendant_ = packet.end;
  is_attendant_watched_ = drives && !is_resting_ && phase_ == Phase::running;
  put(Reason::attendant_inhibit, packet.inhibit, packet);
  put(Reason::attendant_fault, (packet.joystick_error && drives) || packet.local_fault, packet);
  put(Reason::attendant_calibration, packet.calibration, packet);
  if (drives) {
    request(packet);
  }
  prove_attendant();
  if (drives) {
    count_neutral(packet);
  }
}

void Leave::attendant_restarted(Time at) {
  is_attendant_watched_ = false;
  deny(Reason::attendant_restart, at);
}

void Leave::attendant_forgotten() {
  is_attendant_watched_ = false;
  for (const Reason reason :
       {Reason::attendant_silence, Reason::attendant_restart, Reason::attendant_inhibit, Reason::attendant_fault,
        Reason::attendant_calibration, Reason::hand_over, Reason::mode}) {
    allow(reason);
  }
}

// SB-08.2: a chair that stands is handed over at once, and the very packet may show the new stick at rest.
void Leave::hand_over(Driver to, Time at) {
  if (is_still_) {
    neutral_run_ = 0;
    deny(Reason::neutral, at);
  } else {
    deny(Reason::hand_over, at);
  }
  allow(Reason::mode);
  if (to == Driver::attendant) {  // the other's stick no longer counts
    allow(Reason::remote_fault);
  } else {
    is_attendant_watched_ = false;
    allow(Reason::attendant_silence);
    allow(Reason::attendant_restart);
  }
}

void Leave::doubt_driver() {
  is_attendant_watched_ = false;
  for (const Reason reason : {Reason::attendant_silence, Reason::attendant_restart, Reason::attendant_fault,
                              Reason::remote_fault, Reason::hand_over, Reason::mode, Reason::neutral}) {
    allow(reason);
  }
}

void Leave::report(const SpmGeneral& packet, Time at) {
  put_told(Reason::told_calibration, packet.calibrates, at);
  put_told(Reason::told_lock, packet.locked, at);
}

// SB-00.7: another mode is another beginning.
void Leave::request(const Joystick& packet) {
  if (!packet.is_doubtful && packet.mode != mode_) {
    mode_ = packet.mode;
    neutral_run_ = doubtful_run_;  // which may have had it already
    deny(Reason::neutral, packet.end);
  }
  put(Reason::mode, packet.mode != 0, packet);
}

// Links and sticks prove themselves by several generals in a row.
void Leave::prove() {
  ++good_run_;
  if (has_emergency() && good_run_ >= limits::proof && is_stop_over_) {  // SB-2.16
    allow(Reason::silence);
    allow(Reason::corrupt);
    allow(Reason::restart);
    neutral_run_ = 0;
  }
}

void Leave::prove_attendant() {
  ++attendant_run_;
  const bool has_stopped = since(Reason::attendant_silence) || since(Reason::attendant_restart);
  if (has_stopped && attendant_run_ >= limits::proof && is_stop_over_) {
    allow(Reason::attendant_silence);
    allow(Reason::attendant_restart);
    neutral_run_ = 0;
  }
}

// What the power module tells of itself ends before it is told: those reasons are none here. Each such report begins
// the count anew.
void Leave::count_neutral(const Joystick& packet) {
  const bool is_only_neutral_awaited =
      since(Reason::neutral) &&
      !earliest_without({Reason::neutral, Reason::mode, Reason::told_calibration, Reason::told_lock});
  neutral_run_ = is_only_neutral_awaited && packet.is_neutral() ? neutral_run_ + 1 : 0;
  doubtful_run_ = packet.is_doubtful ? doubtful_run_ + 1 : 0;
  if (neutral_run_ >= limits::proof) {
    allow(Reason::neutral);
  }
}

std::optional<Time> Leave::earliest_without(std::initializer_list<Reason> left_out) const {
  std::optional<Time> earliest;
  for (std::size_t i = 0; i < reason_count; ++i) {
    const bool counts = std::none_of(left_out.begin(), left_out.end(), [&](Reason one) { return place_of(one) == i; });
    if (counts && since_[i]) {
      earliest = std::min(earliest.value_or(*since_[i]), *since_[i]);
    }
  }
  return earliest;
}

std::optional<Time> Leave::denied_to_actuators_since() const {
  return earliest_without({Reason::mode});
}

std::optional<Time> Leave::denied_but_for_mode_since() const {
  return earliest_without({Reason::mode, Reason::neutral});
}

void Leave::power_up(const Packet& packet) {
  if (phase_ != Phase::running) {
    phase_ = Phase::greeting;
    return;
  }
  if (packet.is_doubtful) {
    return;
  }
  phase_ = Phase::greeting;
  is_watched_ = is_attendant_watched_ = false;
  corrupt_run_ = 0;
  deny(Reason::restart, packet.end);  // SB-3.4
  deny(Reason::power_up_phase, packet.end);
}

void Leave::corrupt(const Packet& packet) {
  if (phase_ == Phase::silent || packet.is_doubtful) {  // SB-2.14: counted from the first power-up packet on
    corrupt_run_ = 0;
    return;
  }
  good_run_ = 0;
  ++corrupt_run_;
  if (corrupt_run_ >= limits::corrupt_run) {
    deny(Reason::corrupt, packet.end);
  }
}

void Leave::advance(Time now, bool is_still) {
  if (is_watched_ && now - *last_general_ >= limits::silence) {
    is_watched_ = false;
    deny(Reason::silence, *last_general_ + limits::silence);
  }
  if (is_attendant_watched_ && now - *last_of_attendant_ >= limits::silence) {
    is_attendant_watched_ = false;
    deny(Reason::attendant_silence, *last_of_attendant_ + limits::silence);
  }
  is_stop_over_ = is_stop_over_ || is_still;
  is_still_ = is_still;
  if (is_still) {
    allow(Reason::hand_over);
  }
}

std::string Leave::tell(Time now) const {
  std::string text;
  for (std::size_t i = 0; i < reason_count; ++i) {
    if (since_[i]) {
      text += fmt::format("{}{} for {:.1f} ms", text.empty() ? "" : ", ", names[i], milliseconds(now - *since_[i]));
    }
  }
  return text.empty() ? "leave to drive" : "no drive: " + text;
}

}  // namespace simulation::monitor
