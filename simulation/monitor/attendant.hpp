// Who drives, as far as one who only listens can tell (SB-09.1, SB-08.2): the attendant control's power-up packet, the
// power module's acknowledgement of it, and the switch in the generals that follow.
//
// Where a packet of the attendant control is doubtful nobody knows, until the power module tells or the next one comes.
#pragma once

#include <optional>

#include "simulation/monitor/general.hpp"

namespace simulation::monitor {

enum class Driver : std::uint8_t { remote, attendant, unknown };

class Attendant {
 public:
  // Power or reset.
  void begin_anew(Time now) { *this = Attendant(), changed_ = now; }
  // The power module begins anew with everybody: it has said its power-up packet.
  void forget(Time now);
  void power_up(const Packet& packet);
  // True if the power module heeds it, or may.
  bool general(const SacuGeneral& packet);
  // What the power module says, in a turn that began then.
  void report(const SpmGeneral& packet, Time began);

  Driver driver() const { return driver_; }
  bool drives() const { return driver_ == Driver::attendant; }
  Time driver_since() const { return changed_; }
  // With the last packet the chair was handed over for certain, or who drives came into doubt.
  bool has_changed_hands() const { return has_changed_hands_; }
  bool is_new_doubt() const { return is_new_doubt_; }
  bool has_restarted_driving() const { return has_restarted_driving_; }
  // An acknowledgement without its cause, or one that was taken back.
  bool is_acknowledged_wrongly() const { return is_acknowledged_wrongly_; }
  const std::optional<SacuGeneral>& last() const { return last_; }  // that was heeded
  bool has_speed_control() const { return (capabilities_ & 1) != 0; }
  int capabilities() const { return capabilities_; }
  const char* tell() const;

 private:
  enum class Phase : std::uint8_t { stranger, introduced, acknowledged, accepted };

  void let_drive(Driver driver, Time at);

  Phase phase_ = Phase::stranger;
  Driver driver_ = Driver::remote;
  Time changed_{};
  Time accepted_{};
  Time doubted_{};
  std::optional<SacuGeneral> last_;
  int capabilities_ = 0;
  bool may_be_introduced_ = false;
  bool may_be_accepted_ = false;
  bool is_restarting_ = false;  // since it drove
  bool has_changed_hands_ = false;
  bool is_new_doubt_ = false;
  bool has_restarted_driving_ = false;
  bool is_acknowledged_wrongly_ = false;
};

}  // namespace simulation::monitor
