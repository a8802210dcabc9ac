#include "simulation/monitor/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

// Types of section 5.
constexpr std::uint8_t type_sr_general = 0x0;
constexpr std::uint8_t type_spm_general = 0x1;
constexpr std::uint8_t type_sr_hhp_data = 0x2;
constexpr std::uint8_t type_sr_power_up = 0x4;
constexpr std::uint8_t type_spm_power_up = 0x5;
constexpr std::uint8_t type_factory_test = 0x7;
constexpr std::uint8_t type_sacu_general = 0x8;
constexpr std::uint8_t type_sacu_power_up = 0x9;

constexpr int clean_generals_needed = 5;
constexpr int clean_answers_needed = 6;  // SB-2.16: five, and what ends may be told one answer later

}  // namespace

Scene::Scene() : ear_([this](const Packet& packet) { hear(packet); }) {
  begin_anew(Time{});
}

void Scene::begin_anew(Time at) {
  wheels.begin_anew(at);
  leave.begin_anew(at);
  supply.begin_anew(at);
  stick.begin_anew();
  attendant.begin_anew(at);
  actuators.begin_anew();
  lamps.begin_anew(at);
  speech.forget();
  ear_.forget();
  limp = {};
  fall = {};
  forget_turns();
  told_inhibited = old_since = remote_heard_ = attendant_heard_ = std::nullopt;
  own_capabilities = std::nullopt;
  remote_capabilities = 0;
  unlit_since = at;
  report = report_before = std::nullopt;
}

void Scene::forget_turns() {
  turn_ = turn_before_ = {};
  is_turn_over_ = true;
}

// ---- the world

bool Scene::take(const BusByte& byte) {
  now = std::max(now, byte.start);
  if (byte.sender == Sender::spm) {
    take_own(byte);
    return true;
  }
  if (!byte.lost && !wake_since && is_powered) {
    take_other(byte);
  }
  return false;
}

void Scene::take_own(const BusByte& byte) {
  said = {};
  said.byte = byte;
  said.begins_turn = speech.take(byte, turn_known_at(byte.start));
  supply.spoke();
  ear_.hear_own(byte);
  if (byte.start < turn_.last) {
    speech.collide();
  }
  if (said.begins_turn) {
    forget_turns();
  }
  said.packet = speech.packet();
  if (said.packet && said.packet->type == type_spm_general) {
    said.general = SpmGeneral(*said.packet);
    read_report(*said.general, speech.answered());
  } else if (said.packet && said.packet->type == type_spm_power_up) {
    read_own_power_up(*said.packet);
  }
}

void Scene::take_other(const BusByte& byte) {
  if (speech.is_speaking_at(byte.start)) {
    speech.collide();
  }
  if (is_turn_over_) {
    turn_before_ = turn_;
    turn_ = {};
    turn_.is_before_power_up = leave.is_silent_phase();
    turn_.begun = byte.start;
    turn_.first_end = byte.end;
    is_turn_over_ = false;
  }
  turn_.last = byte.end;
  ear_.hear(byte);
}

void Scene::take_wake(bool is_asserted, Time at) {
  wake_since = is_asserted ? std::optional(at) : std::nullopt;
  ear_.forget();
  speech.collide();
  forget_turns();
}

void Scene::take_power(bool powered, Time at) {
  is_powered = powered;
  begin_anew(at);
}

void Scene::take(const Sample& sample) {
  now = sample.at;
  was_reset = sample.resets != resets_;
  resets_ = sample.resets;
  // Latched again without a new supply: it was woken before the old one had died.
  const bool is_latched_anew = sample.pins.power_latch && !supply.is_latched() && supply.was_latched();
  if (was_reset || is_latched_anew) {
    begin_anew(now);
  }
  ear_.advance(now);
  speech.advance(now);
  wheels.take(sample.pins, sample.chair.left_current, sample.chair.right_current, now);
  actuators.advance(sample.pins, now);
  lamps.advance(sample.pins, now);
  leave.advance(now, wheels.is_still());
  supply.advance(now, sample.pins.power_latch, wheels.is_still());
  stick.advance(wheels);
  if (const auto accepted = supply.button_accepted()) {
    leave.button_accepted(*accepted);
  }
  if (supply.is_confirmed()) {
    leave.rest();
  }
  if (!limp.caused) {
    limp.caused = leave.first_emergency();
  }
  if (attendant_heard_ && now - *attendant_heard_ >= limits::silence) {
    limp.of_attendant = std::nullopt;
  }
  follow_fall();
}

void Scene::follow_fall() {
  const auto denied = leave.denied_since();
  if (!denied || wheels.is_zero()) {
    fall = std::nullopt;
  } else if (!fall) {
    fall = Fall{*denied, std::max(wheels.largest(), wheels.largest_before()), leave.first_reason()};
  }
}

// ---- the bus

void Scene::hear(const Packet& packet) {
  turn_.is_doubtful = turn_.is_doubtful || packet.is_doubtful;
  switch (packet.kind) {
    case Packet::Kind::packet:
      if (!packet.is_doubtful) {
        leave.sound();
      }
      hear_packet(packet);
      break;
    case Packet::Kind::finished:
      turn_.finished = packet.end;
      is_turn_over_ = true;
      break;
    case Packet::Kind::corrupt:
      turn_.has_corrupt = true;
      leave.corrupt(packet);
      break;
    case Packet::Kind::silence:
      is_turn_over_ = true;
      break;
  }
}

void Scene::hear_packet(const Packet& packet) {
  switch (packet.type) {
    case type_sr_general:
      if (!leave.is_silent_phase()) {  // SB-3.1
        hear_general(SrGeneral(packet));
      }
      break;
    case type_sr_power_up:
      turn_.has_power_up = true;
      remote_capabilities = Capabilities::of_remote(packet) | (packet.is_doubtful ? remote_capabilities : 0);
      judge_lighting(packet.end);
      leave.power_up(packet);
      supply.heard(packet.end, packet.is_doubtful);
      break;
    case type_sr_hhp_data:
      if (leave.is_running()) {  // SB-4.4
        supply.heard(packet.end, packet.is_doubtful);
      }
      break;
    case type_factory_test:
      turn_.has_factory_test = true;
      break;
    case type_sacu_general:
      turn_.has_attendant = true;
      hear_attendant(SacuGeneral(packet));
      break;
    case type_sacu_power_up:
      turn_.has_attendant = true;
      hear_attendants_power_up(packet);
      break;
    default:
      break;
  }
}

void Scene::hear_general(const SrGeneral& packet) {
  turn_.general = packet;
  remote_heard_ = packet.end;
  const Driver driver = attendant.driver();
  leave.general(packet, driver);
  supply.general(packet, driver == Driver::remote);
  lamps.take(packet);
  if (driver == Driver::remote) {
    stick.take(packet);
  }
  if (driver != Driver::attendant) {
    actuators.take(packet);
  }
  told_inhibited = std::nullopt;
  if (!packet.is_doubtful) {
    read_limp(packet);
    old_since = packet.is_old ? old_since.value_or(packet.end) : std::optional<Time>();
  }
}

void Scene::read_limp(const SrGeneral& packet) {
  if (packet.pot_error && !limp.caused) {
    limp.caused = packet.end;
  }
  limp.clean_generals = packet.non_critical_fault ? 0 : limp.clean_generals + 1;
  if (packet.non_critical_fault) {
    limp.non_critical = limp.non_critical.value_or(packet.end);
  } else if (limp.clean_generals >= clean_generals_needed) {
    limp.non_critical = std::nullopt;
  }
}

void Scene::hear_attendant(const SacuGeneral& packet) {
  if (!attendant.general(packet)) {
    return;
  }
  attendant_heard_ = packet.end;
  obey_change_of_driver(packet.end);
  leave.attendant_general(packet, attendant.driver());
  if (attendant.drives() && !attendant.has_changed_hands()) {
    stick.take(packet);
  }
  if (attendant.driver() != Driver::remote) {
    actuators.take(packet);
  }
  if (attendant.drives() && !packet.is_neutral()) {
    supply.driver_acted(packet.end);
  }
  told_inhibited = std::nullopt;
  if (!packet.non_critical_fault) {
    limp.of_attendant = std::nullopt;
  } else if (!packet.is_doubtful) {
    limp.of_attendant = limp.of_attendant.value_or(packet.end);
  }
  const bool has_pot_failed = packet.pot_error && attendant.drives() && attendant.has_speed_control();
  if (has_pot_failed && !packet.is_doubtful && !limp.caused) {
    limp.caused = packet.end;
  }
}

void Scene::hear_attendants_power_up(const Packet& packet) {
  report = std::nullopt;
  attendant.power_up(packet);
  if (attendant.has_restarted_driving()) {
    leave.attendant_restarted(packet.end);
  }
  obey_change_of_driver(packet.end);
}

// Two sticks: what the old one showed counts no more, and the new one's first general not yet.
void Scene::obey_change_of_driver(Time at) {
  if (attendant.has_changed_hands()) {
    leave.hand_over(attendant.driver(), at);
  } else if (attendant.is_new_doubt()) {
    leave.doubt_driver();
  }
  if (attendant.driver_since() == at) {
    stick.begin_anew();
  }
}

void Scene::read_own_power_up(const Packet& packet) {
  report = std::nullopt;  // what was established holds no longer
  own_capabilities = Capabilities::of_power_module(packet);
  judge_lighting(packet.end);
  attendant.forget(packet.end);
  if (attendant.has_changed_hands()) {
    stick.begin_anew();
  }
  leave.attendant_forgotten();
  attendant_heard_ = limp.of_attendant = std::nullopt;
}

// SB-3.6. What it has not told, because its packet met another, it may have.
void Scene::judge_lighting(Time at) {
  const bool is_lit =
      (own_capabilities.value_or(Capabilities::lighting) & remote_capabilities & Capabilities::lighting) != 0;
  unlit_since = is_lit ? std::optional<Time>() : unlit_since.value_or(at);
}

void Scene::read_report(const SpmGeneral& packet, const Turn& answered) {
  report_before = report;
  report = packet;
  const bool was_in_doubt = attendant.driver() == Driver::unknown;
  attendant.report(packet, speech.began());
  if (was_in_doubt && attendant.driver() != Driver::unknown) {
    stick.begin_anew();
  }
  supply.report(packet, said.byte.end);
  leave.report(packet, said.byte.end);
  actuators.report(packet, said.byte.end);
  if (packet.drive_inhibited) {
    told_inhibited = said.byte.end;
  }
  const auto& heeded = attendant.last();
  const bool is_clean =
      answered.general && !answered.general->non_critical_fault && !(heeded && heeded->non_critical_fault);
  limp.clean_answers = is_clean ? limp.clean_answers + 1 : 0;
  constexpr int user_fault = 1;  // SB-01.9: never the cause of a LIMP; and the slowdown input has no state
  if (packet.slowdown && packet.state > user_fault && limp.clean_answers > clean_answers_needed) {
    limp.is_latched_as_told = true;
  }
}

// ---- what is asked

Time Scene::silence() const {
  if (!remote_heard_) {
    return Time::max();
  }
  const bool needs_attendant = attendant.drives() && attendant_heard_;
  return wheels.before_at() - (needs_attendant ? std::min(*remote_heard_, *attendant_heard_) : *remote_heard_);
}

bool Scene::drove(Driver driver) const {
  return attendant.driver() == driver && speech.began() - attendant.driver_since() > limits::turn;
}

bool Scene::is_denied(Reason reason) const {
  const auto since = leave.since(reason);
  return since && wheels.before_at() - *since >= limits::reaction;
}

bool Scene::is_denied() const {
  const auto since = leave.denied_since();
  return since && wheels.before_at() - *since >= limits::reaction;
}

std::string Scene::tell() const {
  return fmt::format("{}; {}; {}; {}; {}; {}", wheels.tell(), attendant.tell(), stick.tell(now), leave.tell(now),
                     supply.tell(now), speech.tell());
}

}  // namespace simulation::monitor
