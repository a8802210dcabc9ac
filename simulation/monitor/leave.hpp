// May the chair be driven, as far as one who only listens can tell? Every reason against it with the moment it began;
// the neutral rule (SB-01.8) after each of them; and the emergency stop, which runs to its end (SB-2.17).
//
// Where the monitor cannot be sure it leaves drive: a reason it names is one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

#include "simulation/monitor/attendant.hpp"
#include "simulation/monitor/general.hpp"

namespace simulation::monitor {

enum class Reason : std::uint8_t {
  power_up_phase,         // SB-3.1
  silence,                // SB-2.15
  corrupt,                // SB-2.14
  restart,                // SB-3.4: a power-up packet of the remote while running
  remote_inhibit,         // SB-00.4
  charger_inhibit,        // SB-00.5
  remote_fault,           // SB-00.6: local fault, joystick error while it drives
  calibration,            // SB-01.10
  mode,                   // SB-00.7: no drive mode is asked for
  power_button,           // SB-4.1
  neutral,                // SB-01.8
  attendant_silence,      // SB-08.5: while it drives
  attendant_restart,      // of one that drives
  attendant_inhibit,      // SB-08.5: whoever drives
  attendant_fault,        // like the remote's
  attendant_calibration,  // SB-01.10
  told_calibration,       // by the power module itself
  told_lock,              // SB-01.1
  hand_over,              // SB-08.2: until the chair stands
};
constexpr std::size_t reason_count = 19;

bool is_emergency(Reason reason);
std::string name_of(Reason reason);

class Leave {
 public:
  // Power or reset: nothing is known.
  void begin_anew(Time now);
  // Everything that was heard, as the power module must have, or may have, heard it.
  void general(const SrGeneral& packet, Driver driver);
  void power_up(const Packet& packet);
  void sound() { corrupt_run_ = 0; }
  void corrupt(const Packet& packet);
  // Of an attendant control that is heeded, with the driver as of this packet.
  void attendant_general(const SacuGeneral& packet, Driver driver);
  void attendant_restarted(Time at);
  void attendant_forgotten();
  void hand_over(Driver to, Time at);
  // Who drives is in doubt: nothing that hangs on it is a reason.
  void doubt_driver();
  // What the power module tells of itself.
  void report(const SpmGeneral& packet, Time at);
  void button_accepted(Time at) { deny(Reason::power_button, at); }
  // Bus idle mode: silence is expected.
  void rest() {
    is_resting_ = true;
    is_watched_ = is_attendant_watched_ = false;
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
  // The same without the reasons that are none to an actuator, or none that must be told in an actuator's mode.
  std::optional<Time> denied_to_actuators_since() const;
  std::optional<Time> denied_but_for_mode_since() const;
  int neutral_run() const { return neutral_run_; }
  std::string tell(Time now) const;

 private:
  enum class Phase : std::uint8_t { silent, greeting, running };

  void deny(Reason reason, Time at);
  void allow(Reason reason);
  void put(Reason reason, bool is_set, const Joystick& packet);
  void put_told(Reason reason, bool is_set, Time at);
  bool has_emergency() const;
  void prove();
  void prove_attendant();
  void request(const Joystick& packet);
  void count_neutral(const Joystick& packet);
  std::optional<Time> earliest_without(std::initializer_list<Reason> left_out) const;

  std::array<std::optional<Time>, reason_count> since_{};
  std::optional<Time> denied_since_;
  Reason first_reason_ = Reason::power_up_phase;
  std::optional<Time> emergency_;
  std::optional<Time> last_general_;
  Phase phase_ = Phase::silent;
  std::optional<Time> last_of_attendant_;
  bool is_watched_ = false;
  bool is_attendant_watched_ = false;
  bool is_still_ = true;
  bool is_resting_ = false;
  bool is_stop_over_ = true;
  int corrupt_run_ = 0;
  int good_run_ = 0;
  int attendant_run_ = 0;
  int doubtful_run_ = 0;  // of the driver's generals
  int mode_ = 0;          // the last for certain
  int neutral_run_ = 0;
};

}  // namespace simulation::monitor
