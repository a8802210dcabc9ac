#include "simulation/monitor/attendant.hpp"

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {

void Attendant::let_drive(Driver driver, Time at) {
  if (driver != driver_) {
    has_changed_hands_ = driver_ != Driver::unknown && driver != Driver::unknown;
    is_new_doubt_ = driver == Driver::unknown && !is_restarting_;
    driver_ = driver;
    changed_ = at;
  }
}

void Attendant::forget(Time now) {
  has_changed_hands_ = is_new_doubt_ = has_restarted_driving_ = false;
  may_be_introduced_ = may_be_introduced_ || phase_ == Phase::introduced || phase_ == Phase::acknowledged;
  phase_ = Phase::stranger;
  may_be_accepted_ = is_restarting_ = false;
  last_ = std::nullopt;
  let_drive(Driver::remote, now);
}

void Attendant::power_up(const Packet& packet) {
  has_changed_hands_ = is_new_doubt_ = has_restarted_driving_ = false;
  const int told = Capabilities::of_attendant(packet);
  capabilities_ = packet.is_doubtful ? capabilities_ | told : told;
  if (packet.is_doubtful) {
    may_be_introduced_ = true;
    doubted_ = packet.end;
    if (phase_ == Phase::accepted) {
      let_drive(Driver::unknown, packet.end);
    }
    return;
  }
  if (driver_ == Driver::attendant) {
    has_restarted_driving_ = is_restarting_ = true;
    let_drive(Driver::unknown, packet.end);
  }
  phase_ = Phase::introduced;
  may_be_accepted_ = false;
}

bool Attendant::general(const SacuGeneral& packet) {
  has_changed_hands_ = is_new_doubt_ = has_restarted_driving_ = false;
  if (phase_ != Phase::acknowledged && phase_ != Phase::accepted) {  // SB-09.1
    return false;
  }
  if (packet.is_doubtful || may_be_introduced_) {
    may_be_accepted_ = true;
    doubted_ = packet.end;
    let_drive(Driver::unknown, packet.end);
    last_ = packet;
    return true;
  }
  if (phase_ == Phase::acknowledged) {
    phase_ = Phase::accepted;
    accepted_ = packet.end;
  }
  last_ = packet;
  const bool has_come_back = is_restarting_;
  is_restarting_ = false;
  let_drive(packet.wants_to_drive ? Driver::attendant : Driver::remote, packet.end);
  has_changed_hands_ = has_changed_hands_ || (has_come_back && driver_ == Driver::remote);
  return true;
}

void Attendant::report(const SpmGeneral& packet, Time began) {
  is_acknowledged_wrongly_ = false;
  if (packet.acknowledges_attendant) {
    const bool is_earned = phase_ == Phase::introduced || phase_ == Phase::acknowledged || may_be_introduced_;
    const bool was_just_accepted = phase_ == Phase::accepted && began - accepted_ < limits::reaction;
    is_acknowledged_wrongly_ = !is_earned && !was_just_accepted;
    if (is_earned) {
      phase_ = Phase::acknowledged;
      may_be_introduced_ = false;
      may_be_accepted_ = may_be_accepted_ && began <= doubted_;
    }
  } else if (phase_ == Phase::acknowledged) {
    is_acknowledged_wrongly_ = !may_be_accepted_;
    phase_ = Phase::accepted;
    accepted_ = began;
  } else if (began > doubted_ && phase_ == Phase::accepted) {
    may_be_introduced_ = false;
  }
  // What is in doubt is as it is told: that is the best one can know.
  if (driver_ == Driver::unknown && !is_restarting_ && began > doubted_) {
    driver_ = packet.sacu_drives ? Driver::attendant : Driver::remote;
    changed_ = began;
  }
}

const char* Attendant::tell() const {
  switch (driver_) {
    case Driver::remote:
      return "the remote drives";
    case Driver::attendant:
      return "the attendant control drives";
    case Driver::unknown:
      break;
  }
  return "who drives is in doubt";
}

}  // namespace simulation::monitor
