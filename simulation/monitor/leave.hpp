// May the chair be driven, as far as one who only listens can tell? Every reason against it with the moment it began;
// the neutral rule (SB-01.8) after each of them; and the emergency stop, which runs to its end (SB-2.17).
//
// Where the monitor cannot be sure it leaves drive: a reason it names is one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "simulation/monitor/general.hpp"

namespace simulation::monitor {

enum class Reason : std::uint8_t {
  power_up_phase,   // SB-3.1
  silence,          // SB-2.15
  corrupt,          // SB-2.14
  restart,          // SB-3.4: a power-up packet of the remote while running
  remote_inhibit,   // SB-00.4
  charger_inhibit,  // SB-00.5
  remote_fault,     // SB-00.6: joystick error, local fault
  calibration,      // SB-01.10
  mode,             // SB-00.7: no drive mode is asked for
  power_button,     // SB-4.1
  neutral,          // SB-01.8
};
constexpr std::size_t reason_count = 11;

bool is_emergency(Reason reason);
std::string name_of(Reason reason);

class Leave {
 public:
  // Power or reset: nothing is known.
  void begin_anew(Time now);
  // Everything that was heard, as the power module must have, or may have, heard it.
  void general(const SrGeneral& packet);
  void power_up(const Packet& packet);
  void sound() { corrupt_run_ = 0; }
  void corrupt(const Packet& packet);
  void button_accepted(Time at) { deny(Reason::power_button, at); }
  // Bus idle mode: silence is expected.
  void rest() {
    is_resting_ = true;
    is_watched_ = false;
  }
  // Each millisecond; `is_still`: no duty, brakes engaged.
  void advance(Time now, bool is_still);

  bool is_silent_phase() const { return phase_ == Phase::silent; }  // no power-up packet yet
  bool is_running() const { return phase_ == Phase::running; }
  std::optional<Time> since(Reason reason) const { return since_[static_cast<std::size_t>(reason)]; }
  // Since when there has been one reason or another, and which was the first.
  std::optional<Time> denied_since() const { return denied_since_; }
  Reason first_reason() const { return first_reason_; }
  // The first emergency since power-up: a cause of LIMP that stays until power-down (SB-2.16).
  std::optional<Time> first_emergency() const { return emergency_; }
  int neutral_run() const { return neutral_run_; }
  std::string tell(Time now) const;

 private:
  enum class Phase : std::uint8_t { silent, greeting, running };

  void deny(Reason reason, Time at);
  void allow(Reason reason);
  void put(Reason reason, bool is_set, const SrGeneral& packet);
  bool has_emergency() const;
  void prove(const SrGeneral& packet);

  std::array<std::optional<Time>, reason_count> since_{};
  std::optional<Time> denied_since_;
  Reason first_reason_ = Reason::power_up_phase;
  std::optional<Time> emergency_;
  std::optional<Time> last_general_;
  Phase phase_ = Phase::silent;
  bool is_watched_ = false;
  bool is_resting_ = false;
  bool is_stop_over_ = true;
  int corrupt_run_ = 0;
  int good_run_ = 0;
  int neutral_run_ = 0;
};

}  // namespace simulation::monitor
