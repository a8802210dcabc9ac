#include "simulation/monitor/leave.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

constexpr std::array<const char*, reason_count> names = {"power-up phase",   "silence",        "corrupt packets",
                                                         "remote restarted", "remote inhibit", "charger inhibit",
                                                         "remote fault",     "calibration",    "mode",
                                                         "power button",     "neutral awaited"};

constexpr std::size_t place_of(Reason reason) {
  return static_cast<std::size_t>(reason);
}

}  // namespace

bool is_emergency(Reason reason) {
  return reason == Reason::silence || reason == Reason::corrupt || reason == Reason::restart;
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
  if (reason != Reason::neutral) {  // SB-01.8
    neutral_run_ = 0;
    deny(Reason::neutral, at);
  }
  if (is_emergency(reason)) {
    good_run_ = 0;
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

void Leave::put(Reason reason, bool is_set, const SrGeneral& packet) {
  if (!is_set) {
    allow(reason);
  } else if (!packet.is_doubtful) {
    deny(reason, packet.end);
    neutral_run_ = 0;
  }
}

bool Leave::has_emergency() const {
  return since(Reason::silence) || since(Reason::corrupt) || since(Reason::restart);
}

void Leave::general(const SrGeneral& packet) {
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
  put(Reason::remote_fault, packet.joystick_error || packet.local_fault, packet);
  put(Reason::calibration, packet.calibration, packet);
  put(Reason::mode, packet.mode != 0, packet);
  prove(packet);
}

// Links and sticks prove themselves by several generals in a row.
void Leave::prove(const SrGeneral& packet) {
  ++good_run_;
  if (has_emergency() && good_run_ >= limits::proof && is_stop_over_) {  // SB-2.16
    allow(Reason::silence);
    allow(Reason::corrupt);
    allow(Reason::restart);
    neutral_run_ = 0;
  }
  const auto reasons = std::count_if(since_.begin(), since_.end(), [](const auto& since) { return since.has_value(); });
  const bool is_only_neutral_awaited = reasons == 1 && since(Reason::neutral);
  neutral_run_ = is_only_neutral_awaited && packet.is_neutral() ? neutral_run_ + 1 : 0;
  if (neutral_run_ >= limits::proof) {
    allow(Reason::neutral);
  }
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
  is_watched_ = false;
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
  is_stop_over_ = is_stop_over_ || is_still;
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
