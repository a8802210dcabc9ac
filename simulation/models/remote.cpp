#include "simulation/models/remote.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr int type_general = 0;
constexpr int type_spm_general = 1;
constexpr int type_hhp_data = 2;
constexpr int type_spm_hhp_data = 3;
constexpr int type_power_up = 4;
constexpr int type_spm_power_up = 5;
constexpr int type_calibration = 6;
constexpr int type_factory_test = 7;
constexpr double nominal_character = 11;  // bit times
constexpr std::size_t longest_data = 8;
constexpr Time communication_limit = 1s;          // SB-3.5
constexpr Time silence_after_power_down = 500ms;  // SB-4.4

// SB-02.2; the programmer's codes above 0x7F are always 0x80 to 0x83.
int to_bus(char character) {
  const int code = static_cast<std::uint8_t>(character);
  return code >= 0x80 ? code - 0x70 : code;
}

// SB-03.2
std::uint8_t to_programmer(std::uint8_t code) {
  if (code >= 0x10 && code <= 0x17) {
    return static_cast<std::uint8_t>(code + 0x70);
  }
  return static_cast<std::uint8_t>(code >= 0x18 && code <= 0x1F ? code + 0xE0 : code);
}

void append(std::vector<std::uint8_t>& turn, const std::vector<std::uint8_t>& packet) {
  turn.insert(turn.end(), packet.begin(), packet.end());
}

}  // namespace

Time RemoteStatistics::least_delay() const {
  return delays.empty() ? Time{} : *std::min_element(delays.begin(), delays.end());
}

Time RemoteStatistics::median_delay() const {
  if (delays.empty()) {
    return {};
  }
  std::vector<Time> sorted = delays;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

Time RemoteStatistics::largest_delay() const {
  return delays.empty() ? Time{} : *std::max_element(delays.begin(), delays.end());
}

void Remote::start(Time now) {
  if (is_on()) {
    return;
  }
  wake_until_ = now + timing.wake;
  is_wake_shown_ = true;
  begin_anew(now);
  if (wake_) {
    wake_(true, now);
  }
}

// Pressed, or its chip was reset.
void Remote::begin_anew(Time now) {
  phase_ = Phase::power_up;
  next_turn_ = now + timing.first_turn;
  turn_from_ = turn_until_ = says_until_ = now;
  awaits_answer_ = has_general_ = is_confirming_ = has_communication_fault_ = false;
  spm_capabilities_ = 0;
  reader_.break_off();
  calibration_.begin_anew();
  factory_test_.begin_anew();
  report_ = {};
}

Time Remote::next_time() const {
  const Time turn = is_on() ? std::min(next_turn_, factory_test_.due()) : Time::max();
  return is_wake_shown_ ? std::min(turn, wake_until_) : turn;
}

void Remote::act(Time now) {
  end_wake_if_due(now);
  if (is_on() && factory_test_.due() <= now) {
    answer_factory_test(now);
  }
  if (!is_on() || now < next_turn_) {
    return;
  }
  next_turn_ += timing.period;
  const bool is_speaking = now < says_until_;  // a turn full of gaps: it lets this beat pass
  if (is_speaking) {
    return;
  }
  judge_last_turn(now);
  if (is_confirming_ && now - std::max(spm_heard_, last_heard_) >= silence_after_power_down) {
    phase_ = Phase::off;
    return;
  }
  if (!is_silent) {
    send_turn(now);
  }
}

void Remote::end_wake_if_due(Time now) {
  if (!is_wake_shown_ || now < wake_until_) {
    return;
  }
  is_wake_shown_ = false;
  if (wake_) {
    wake_(false, now);
  }
}

void Remote::judge_last_turn(Time now) {
  if (awaits_answer_) {
    ++statistics_.missed;
  }
  awaits_answer_ = false;
  reader_.break_off();
  statistics_.bad = reader_.bad();
  if (phase_ == Phase::general && now - spm_heard_ >= communication_limit) {
    has_communication_fault_ = true;
  }
}

void Remote::send_turn(Time now) {
  const std::vector<std::uint8_t> turn = make_turn();
  awaits_answer_ = phase_ == Phase::general;
  has_general_ = false;
  allowed_hhp_data_ = controls.hhp_may_send;
  answer_from_.reset();
  turn_from_ = now;
  turn_until_ = says_until_ = transmit_turn(turn, now, timing, transmit_);
}

void Remote::answer_factory_test(Time now) {
  const auto answer = factory_test_.take_answer();
  if (now >= says_until_) {
    says_until_ = transmit_turn(answer, now, timing, transmit_);
  }
}

// At most 9 + 10 + 3 bytes and TF (SB-2.2).
std::vector<std::uint8_t> Remote::make_turn() {
  if (phase_ == Phase::power_up) {
    auto turn = power_up_packet();
    turn.push_back(end_of_turn);
    return turn;
  }
  auto turn = general_packet();
  std::vector<int> data;
  for (const char character : programmer.take(longest_data)) {
    data.push_back(to_bus(character));
  }
  if (!data.empty()) {
    append(turn, seal(type_hhp_data, data));  // SB-02.1
  }
  if (controls.calibration_active) {
    calibration_.watch(controls.speed, controls.direction);
  } else {
    calibration_.begin_anew();
  }
  if (controls.calibration_active || sends_calibration) {
    append(turn, calibration_packet());  // SB-06.1
  }
  turn.push_back(end_of_turn);
  return turn;
}

std::vector<std::uint8_t> Remote::power_up_packet() const {
  std::vector<int> data{identity.type,         identity.year - 2000, identity.month & 0x0F,
                        identity.serial >> 14, identity.serial >> 7, identity.serial,
                        identity.version,      identity.capabilities};  // SB-04.1
  data.resize(static_cast<std::size_t>(std::clamp(identity.power_up_length, 6, 8)));
  return seal(type_power_up, data);
}

std::vector<std::uint8_t> Remote::general_packet() const {
  const RemoteControls& c = controls;
  const bool has_lamps = is_insistent || (identity.capabilities & spm_capabilities_ & 0x01) != 0;
  const bool has_actuators = is_insistent || ((identity.capabilities & 0x02) != 0 && (spm_capabilities_ & 0x06) != 0);
  const bool is_actuator_mode = c.mode >= 1 && c.mode <= 3;
  const int mode = is_actuator_mode && !has_actuators ? 0 : c.mode & 0x0F;
  // SB-00.1, SB-00.2
  std::vector<int> data{c.speed >> 3,
                        c.direction >> 3,
                        c.pot >> 1,
                        (c.pot & 1) << 6 | (c.speed & 7) << 3 | (c.direction & 7),
                        c.joystick_error << 6 | c.pot_error << 5 | c.local_fault << 4 | c.charger_inhibit << 3 |
                            c.power_button << 2 | c.horn << 1 | static_cast<int>(c.lock),
                        (has_lamps && c.hazard) << 6 | (has_lamps && c.left_indicator) << 5 |
                            (has_lamps && c.right_indicator) << 4 | c.remote_inhibit << 3 | c.hhp_may_send << 2 |
                            c.calibration_active << 1 | static_cast<int>(is_confirming_),
                        c.non_critical_fault << 5 | (has_lamps && c.headlight) << 4 | mode};
  data.resize(identity.general_length == 6 ? 6 : 7);
  return seal(type_general, data);
}

std::vector<std::uint8_t> Remote::calibration_packet() const {
  return seal(type_calibration, {calibration_.data(controls.calibration_second_pass)});
}

void Remote::hear(const Reception& reception) {
  if (!is_on() || reception.at < says_until_) {
    return;
  }
  if (!answer_from_) {
    answer_from_ = reception.at - timing.bits(bits_until_sampled);
  }
  last_heard_ = reception.at;
  const Time ended = reception.at + timing.bits(nominal_character - bits_until_sampled);
  factory_test_.hear_character(ended);
  switch (reader_.hear(reception, timing.bits(1))) {
    case PacketReader::Heard::packet:
      take_packet(reception.at, ended);
      break;
    case PacketReader::Heard::end_of_turn:
      factory_test_.hear_end_of_turn(ended);
      take_end_of_turn();
      break;
    case PacketReader::Heard::nothing_yet:
      break;
  }
  statistics_.bad = reader_.bad();
}

void Remote::take_packet(Time at, Time ended) {
  switch (reader_.type()) {
    case type_spm_power_up:
      if (phase_ == Phase::power_up) {
        spm_capabilities_ = reader_.data()[0] & 0x07;  // SB-05.1: the rest is undocumented
        phase_ = Phase::general;
        spm_heard_ = at;
      }
      break;
    case type_spm_general:
      if (reader_.data().size() < SpmReport::length) {
        reader_.reject();  // SB-5.3
      } else {
        take_general(at);
      }
      break;
    case type_spm_hhp_data:
      take_hhp_data();
      break;
    case type_factory_test:
      if (factory_test_.take(reader_.data(), ended)) {
        begin_anew(at);  // SB-07.1: at once, without an answer
      }
      break;
    default:
      break;
  }
}

void Remote::take_general(Time at) {
  std::copy_n(reader_.data().begin(), SpmReport::length, report_.data.begin());
  report_.at = at;
  spm_heard_ = at;
  has_general_ = true;
  has_communication_fault_ = false;
  is_confirming_ = report_.is_power_down_now();  // SB-4.3
}

// What comes against the flow control is shown all the same, and counted (SB-03.1).
void Remote::take_hhp_data() {
  statistics_.unwanted += allowed_hhp_data_ ? 0 : 1;
  for (const std::uint8_t code : reader_.data()) {
    programmer.show(to_programmer(code));
  }
}

void Remote::take_end_of_turn() {
  if (!awaits_answer_ || !has_general_) {
    return;
  }
  awaits_answer_ = false;
  ++statistics_.answers;
  statistics_.delays.push_back(*answer_from_ - turn_until_);
}

}  // namespace simulation
