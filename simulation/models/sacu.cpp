#include "simulation/models/sacu.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr int type_sr_general = 0;
constexpr int type_spm_general = 1;
constexpr int type_sr_hhp_data = 2;
constexpr int type_spm_hhp_data = 3;
constexpr int type_sr_power_up = 4;
constexpr int type_spm_power_up = 5;
constexpr int type_calibration = 6;
constexpr int type_factory_test = 7;
constexpr int type_general = 8;
constexpr int type_power_up = 9;
constexpr int type_spm_settings = 10;

constexpr double nominal_character = 11;  // bit times

}  // namespace

void Sacu::attach() {
  is_attached_ = true;
  reader_.break_off();
  begin_anew();
}

// Plugged in, or its chip was reset.
void Sacu::begin_anew() {
  speaker_ = Speaker::nobody;
  turn_due_ = silence_due_ = never;
  has_introduced_itself_ = is_acknowledged_ = false;
  report_ = {};
  calibration_.begin_anew();
  factory_test_.begin_anew();
}

Time Sacu::next_time() const {
  return is_attached_ ? std::min({turn_due_, silence_due_, factory_test_.due()}) : never;
}

void Sacu::act(Time now) {
  if (silence_due_ <= now) {
    silence_due_ = never;
    take_end_of_turn(now - timing.pause);
  }
  if (factory_test_.due() <= now) {
    answer_factory_test(now);
  }
  if (turn_due_ <= now) {
    turn_due_ = never;
    send_turn(now);
  }
}

void Sacu::send_turn(Time now) {
  if (is_silent || now < turn_until_) {
    return;
  }
  turn_until_ = transmit_turn(make_turn(), now, timing, transmit_);
}

void Sacu::answer_factory_test(Time now) {
  const auto answer = factory_test_.take_answer();
  if (now >= turn_until_) {
    turn_until_ = transmit_turn(answer, now, timing, transmit_);
  }
}

// At most 9 bytes and TF, or 8 + 3 and TF (SB-2.2).
std::vector<std::uint8_t> Sacu::make_turn() {
  if (!is_acknowledged_ && !insists) {
    has_introduced_itself_ = true;
    auto turn = power_up_packet();
    turn.push_back(end_of_turn);
    return turn;
  }
  auto turn = general_packet();
  if (controls.calibration_active) {
    calibration_.watch(controls.speed, controls.direction);
  } else {
    calibration_.begin_anew();
  }
  if (controls.calibration_active || sends_calibration) {
    const auto calibration = calibration_packet();
    turn.insert(turn.end(), calibration.begin(), calibration.end());  // SB-06.1
  }
  turn.push_back(end_of_turn);
  return turn;
}

// SB-09.1
std::vector<std::uint8_t> Sacu::power_up_packet() const {
  return seal(type_power_up, {identity.year - 2000, identity.month & 0x0F, identity.serial >> 14, identity.serial >> 7,
                              identity.serial, identity.version, identity.capabilities});
}

// SB-08.1
std::vector<std::uint8_t> Sacu::general_packet() const {
  const SacuControls& c = controls;
  return seal(type_general,
              {c.speed >> 3, c.direction >> 3, c.pot >> 1, (c.pot & 1) << 6 | (c.speed & 7) << 3 | (c.direction & 7),
               c.joystick_error << 6 | c.pot_error << 5 | c.local_fault << 4 | c.calibration_active << 3 |
                   c.is_attendant << 2 | c.non_critical_fault << 1 | static_cast<int>(c.drive_inhibit),
               c.mode & 0x0F});
}

std::vector<std::uint8_t> Sacu::calibration_packet() const {
  return seal(type_calibration, {calibration_.data(controls.calibration_second_pass)});
}

void Sacu::hear(const Reception& reception) {
  if (!is_attached_ || reception.at < turn_until_) {
    return;
  }
  const Time ended = reception.at + timing.bits(nominal_character - bits_until_sampled);
  silence_due_ = ended + longest_silence;
  factory_test_.hear_character(ended);
  switch (reader_.hear(reception, timing.bits(1))) {
    case PacketReader::Heard::packet:
      take_packet(reception.at, ended);
      break;
    case PacketReader::Heard::end_of_turn:
      factory_test_.hear_end_of_turn(ended);
      take_end_of_turn(ended);
      break;
    case PacketReader::Heard::nothing_yet:
      break;
  }
}

void Sacu::take_packet(Time at, Time ended) {
  switch (reader_.type()) {
    case type_sr_general:
    case type_sr_hhp_data:
    case type_sr_power_up:
      speaker_ = Speaker::remote;
      break;
    case type_spm_power_up:
      has_introduced_itself_ = is_acknowledged_ = false;
      speaker_ = Speaker::power_module;
      break;
    case type_spm_general:
      if (reader_.data().size() < SpmReport::length) {
        reader_.reject();  // SB-5.3
        break;
      }
      std::copy_n(reader_.data().begin(), SpmReport::length, report_.data.begin());
      report_.at = at;
      is_acknowledged_ = is_acknowledged_ || (has_introduced_itself_ && report_.is_sacu_acknowledged());
      speaker_ = Speaker::power_module;
      break;
    case type_spm_hhp_data:
    case type_spm_settings:
      speaker_ = Speaker::power_module;
      break;
    case type_factory_test:
      if (factory_test_.take(reader_.data(), ended)) {
        begin_anew();  // SB-07.1: at once, without an answer
      }
      break;
    default:
      break;
  }
}

// A SACU sends after the power module (SB-2.8).
void Sacu::take_end_of_turn(Time ended) {
  const Speaker awaited = timing.is_rash ? Speaker::remote : Speaker::power_module;
  if (speaker_ == awaited) {
    turn_due_ = ended + timing.pause;
  }
  speaker_ = Speaker::nobody;
  silence_due_ = never;
}

}  // namespace simulation
