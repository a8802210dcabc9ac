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
  speech.forget();
  ear_.forget();
  limp = {};
  fall = {};
  forget_turns();
  told_inhibited = old_since = actuator_asked = std::nullopt;
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
    case type_sacu_power_up:
      turn_.has_attendant = true;
      break;
    default:
      break;
  }
}

void Scene::hear_general(const SrGeneral& packet) {
  turn_.general = packet;
  leave.general(packet);
  supply.general(packet);
  stick.take(packet);
  told_inhibited = std::nullopt;
  if (packet.is_doubtful) {
    return;
  }
  if (packet.pot_error && !limp.caused) {
    limp.caused = packet.end;
  }
  limp.clean_generals = packet.non_critical_fault ? 0 : limp.clean_generals + 1;
  if (packet.non_critical_fault) {
    limp.non_critical = limp.non_critical.value_or(packet.end);
  } else if (limp.clean_generals >= clean_generals_needed) {
    limp.non_critical = std::nullopt;
  }
  old_since = packet.is_old ? old_since.value_or(packet.end) : std::optional<Time>();
  if (packet.mode >= 1 && packet.mode <= 3 && !packet.is_neutral()) {
    actuator_asked = packet.end;
  }
}

void Scene::read_report(const SpmGeneral& packet, const Turn& answered) {
  report_before = report;
  report = packet;
  supply.report(packet);
  if (packet.drive_inhibited) {
    told_inhibited = said.byte.end;
  }
  const bool is_clean = answered.general && !answered.general->non_critical_fault;
  limp.clean_answers = is_clean ? limp.clean_answers + 1 : 0;
  if (packet.slowdown && packet.state != 0 && limp.clean_answers > clean_answers_needed) {
    limp.is_latched_as_told = true;
  }
}

// ---- what is asked

Time Scene::silence() const {
  return stick.general() ? wheels.before_at() - stick.general()->end : Time::max();
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
  return fmt::format("{}; {}; {}; {}; {}", wheels.tell(), stick.tell(now), leave.tell(now), supply.tell(now),
                     speech.tell());
}

}  // namespace simulation::monitor
