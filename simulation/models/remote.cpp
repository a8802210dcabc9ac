#include "simulation/models/remote.hpp"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

constexpr std::uint8_t marker = 0x80;
constexpr std::uint8_t end_of_turn = 0x0F;
constexpr std::size_t type_spm_general = 1;
constexpr std::size_t type_spm_power_up = 5;
constexpr std::size_t spm_general_length = 7;
constexpr double sampled_after = 9.625;           // bit times from the start edge to Reception::at
constexpr Time packet_limit = 3ms;                // SB-2.11
constexpr Time communication_limit = 1s;          // SB-3.5
constexpr Time silence_after_power_down = 500ms;  // SB-4.4

std::size_t data_length(std::uint8_t start_byte) {
  return static_cast<std::size_t>(start_byte >> 4) + 1;
}

std::vector<std::uint8_t> seal(int type, const std::vector<int>& data) {
  const int start = static_cast<int>(data.size() - 1) << 4 | type;
  std::vector<std::uint8_t> packet{static_cast<std::uint8_t>(start)};
  int sum = start;
  for (const int value : data) {
    packet.push_back(static_cast<std::uint8_t>(marker | (value & 0x7F)));
    sum += value & 0x7F;
  }
  packet.push_back(static_cast<std::uint8_t>(marker | (0x7F - (sum & 0x7F))));  // SB-2.5
  return packet;
}

// SB-2.5: the low seven bits of everything, the checksum included, come to 0x7F.
bool adds_up(const std::vector<std::uint8_t>& packet) {
  int sum = 0;
  for (const std::uint8_t byte : packet) {
    sum += byte & 0x7F;
  }
  return (sum & 0x7F) == 0x7F;
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
  phase_ = Phase::power_up;
  next_turn_ = now + timing.first_turn;
  wake_until_ = now + timing.wake;
  turn_from_ = turn_until_ = now;
  awaits_answer_ = has_general_ = is_confirming_ = has_communication_fault_ = false;
  spm_capabilities_ = 0;
  packet_.clear();
  report_ = {};
  is_wake_shown_ = true;
  if (wake_) {
    wake_(true, now);
  }
}

Time Remote::next_time() const {
  const Time turn = is_on() ? next_turn_ : Time::max();
  return is_wake_shown_ ? std::min(turn, wake_until_) : turn;
}

void Remote::act(Time now) {
  end_wake_if_due(now);
  if (!is_on() || now < next_turn_) {
    return;
  }
  next_turn_ += timing.period;
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
  if (!packet_.empty()) {
    packet_.clear();
    ++statistics_.bad;
  }
  if (phase_ == Phase::general && now - spm_heard_ >= communication_limit) {
    has_communication_fault_ = true;
  }
}

void Remote::send_turn(Time now) {
  std::vector<std::uint8_t> turn = phase_ == Phase::general ? general_packet() : power_up_packet();
  turn.push_back(end_of_turn);
  awaits_answer_ = phase_ == Phase::general;
  has_general_ = false;
  answer_from_.reset();
  turn_from_ = now;
  const double bits_of_a_byte = 9.0 + timing.stop_bits;
  double sent = 0;
  Time gaps{};
  for (const std::uint8_t byte : turn) {
    if (transmit_) {
      transmit_(byte, now + bits(sent) + gaps);
    }
    sent += bits_of_a_byte;
    gaps += timing.gap;
  }
  turn_until_ = now + bits(sent) + gaps - timing.gap;
}

Time Remote::bits(double count) const {
  return Time(std::llround(count * timing.bit_us * 1000));
}

std::vector<std::uint8_t> Remote::power_up_packet() const {
  std::vector<int> data{identity.type,         identity.year - 2000, identity.month & 0x0F,
                        identity.serial >> 14, identity.serial >> 7, identity.serial,
                        identity.version,      identity.capabilities};  // SB-04.1
  data.resize(static_cast<std::size_t>(std::clamp(identity.power_up_length, 6, 8)));
  return seal(4, data);
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
  return seal(0, data);
}

void Remote::hear(const Reception& reception) {
  if (!is_on() || reception.at < turn_until_) {
    return;
  }
  const Time from = reception.at - bits(sampled_after);
  if (!answer_from_) {
    answer_from_ = from;
  }
  // A run of stray bytes is kept as a packet, too: it is bad once, when it ends.
  if (!packet_.empty() && from - last_heard_ > packet_limit) {
    packet_.clear();
    ++statistics_.bad;
  }
  last_heard_ = reception.at;
  const bool is_start = (reception.value & marker) == 0 && !reception.framing_error;
  if (is_start && !packet_.empty()) {
    packet_.clear();
    ++statistics_.bad;
  }
  if (is_start && reception.value == end_of_turn) {
    take_end_of_turn();
    return;
  }
  // A spoiled byte turns what it stands in into strays.
  if (reception.framing_error) {
    packet_.assign(1, marker);
    return;
  }
  packet_.push_back(reception.value);
  const bool is_packet = (packet_.front() & marker) == 0;
  if (is_packet && packet_.size() == data_length(packet_.front()) + 2) {
    take_packet(reception.at);
    packet_.clear();
  }
}

void Remote::take_packet(Time at) {
  if (!adds_up(packet_)) {
    ++statistics_.bad;
    return;
  }
  const std::size_t type = packet_.front() & 0x0FU;
  if (type == type_spm_power_up && phase_ == Phase::power_up) {
    spm_capabilities_ = packet_[1] & 0x07;  // SB-05.1: the rest is undocumented
    phase_ = Phase::general;
    spm_heard_ = at;
  }
  if (type != type_spm_general) {
    return;
  }
  if (data_length(packet_.front()) < spm_general_length) {
    ++statistics_.bad;
    return;
  }
  take_general(at);
}

void Remote::take_general(Time at) {
  for (std::size_t i = 0; i < spm_general_length; ++i) {
    report_.data[i] = packet_[i + 1] & 0x7F;
  }
  report_.at = at;
  spm_heard_ = at;
  has_general_ = true;
  has_communication_fault_ = false;
  is_confirming_ = report_.is_power_down_now();  // SB-4.3
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
