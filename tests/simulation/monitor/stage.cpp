#include "tests/simulation/monitor/stage.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

namespace stage {
namespace {

constexpr Time sampled_after = 250us;  // a character is told when its first stop bit has been sampled
constexpr Time answer_after = 44us;
constexpr Time period = 20ms;

// One clause that is not asked: its tests must then fail (tests/tools/clauses).
std::vector<std::string> clauses_left_out() {
  const char* id = std::getenv("PILOTFISH_WITHOUT_CLAUSE");
  return id == nullptr ? std::vector<std::string>{} : std::vector<std::string>{id};
}

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  std::vector<std::uint8_t> bytes;
  std::istringstream in(text);
  in >> std::hex;
  for (int value = 0; in >> value;) {
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return bytes;
}

int nearer(int value, int goal, int step) {
  return value + std::clamp(goal - value, -step, step);
}

}  // namespace

Stage::Stage() : monitor_(std::make_unique<monitor::Monitor>(clauses_left_out())) {}

void Stage::power(bool is_on) {
  is_powered_ = is_on;
  pins = Pins{};
  jump(0, 0);
  monitor_->on_power(is_on, now);
}

void Stage::wake(bool is_on) {
  monitor_->on_wake(is_on, now);
}

void Stage::reset() {
  ++resets_;
}

void Stage::run_until(Time end) {
  for (Time next = (sampled_ / 1ms + 1) * 1ms; next <= end; next += 1ms) {
    sampled_ = next;
    sample();
  }
  now = std::max(now, end);
}

void Stage::sample() {
  for (auto& [at, deed] : deeds_) {
    if (deed && at <= sampled_) {
      std::exchange(deed, nullptr)();
    }
  }
  left_ = nearer(left_, left_goal_, step_);
  right_ = nearer(right_, right_goal_, step_);
  pins.left_duty = static_cast<std::uint16_t>(std::abs(left_));
  pins.right_duty = static_cast<std::uint16_t>(std::abs(right_));
  pins.left_forward = left_ >= 0;
  pins.right_forward = right_ >= 0;
  Sample sample;
  sample.at = sampled_;
  sample.pins = pins;
  sample.spm_powered = is_powered_;
  sample.resets = resets_;
  sample.chair.left_current = left_current_;
  sample.chair.right_current = right_current_;
  monitor_->on_sample(sample);
}

void Stage::says(Sender sender, const std::string& bytes, Time character) {
  for (const std::uint8_t value : bytes_of(bytes)) {
    BusByte byte;
    byte.start = now;
    byte.end = now + character;
    byte.sender = sender;
    byte.sent = byte.heard = value;
    run_until(byte.start + sampled_after);
    monitor_->on_byte(byte);
    run_until(byte.end);
  }
}

void Stage::turn(const std::string& bytes, const std::string& answer) {
  says(Sender::sr, bytes);
  run(answer_after);
  says(Sender::spm, answer);
}

void Stage::cycle(const std::string& bytes, const std::string& answer) {
  const Time end = now + period;
  turn(bytes, answer);
  run_until(end);
}

void Stage::cycles(int count, const std::string& bytes, const std::string& answer) {
  for (int i = 0; i < count; ++i) {
    cycle(bytes, answer);
  }
}

void Stage::trio(const std::string& remote, const std::string& answer, const std::string& attendant) {
  const Time end = now + period;
  turn(remote, answer);
  run(100us);
  says(Sender::sacu, attendant);
  run_until(end);
}

void Stage::trios(int count, const std::string& remote, const std::string& answer, const std::string& attendant) {
  for (int i = 0; i < count; ++i) {
    trio(remote, answer, attendant);
  }
}

void Stage::drive(int left, int right, int step) {
  left_goal_ = left;
  right_goal_ = right;
  step_ = step;
}

void Stage::jump(int left, int right) {
  left_ = left_goal_ = left;
  right_ = right_goal_ = right;
}

void Stage::brakes(bool are_released) {
  pins.left_brake_release = pins.right_brake_release = are_released;
  pins.bridge_enable = are_released;
  pins.motor_relay = are_released;
}

void Stage::greet(const char* answer, const char* remote) {
  power(true);
  pins.power_latch = true;
  run_until(10ms);
  cycle(remote, answer);
}

void Stage::wake_up(const char* answer) {
  greet(answer);
  cycles(4, sr::neutral, spm::inhibited);
  cycle(sr::neutral, spm::ready);
}

void Stage::meet_attendant(const char* power_up) {
  trio(sr::neutral, spm::ready, power_up);
  trio(sr::neutral, spm::acknowledging, sacu::standing_by);
  trio(sr::neutral, spm::ready, sacu::standing_by);
}

void Stage::hand_over() {
  trio(sr::neutral, spm::ready, sacu::neutral);
  trios(4, sr::neutral, spm::attendant_inhibited, sacu::neutral);
  trio(sr::neutral, spm::attendant, sacu::neutral);
}

void Stage::attend_at_100() {
  trio(sr::neutral, spm::attendant, sacu::forward);
  brakes(true);
  trios(6, sr::neutral, spm::attendant_driving, sacu::forward);
  drive(100, 100);
  trios(7, sr::neutral, spm::attendant_driving, sacu::forward);
}

void Stage::set_off(const char* bytes) {
  wake_up();
  cycle(bytes, spm::ready);
  brakes(true);
  cycles(6, bytes, spm::driving);
}

void Stage::drive_at(int duty) {
  set_off(duty < 0 ? sr::backward : sr::forward);
  drive(duty, duty);
  cycles(std::abs(duty) / 20 + 2, duty < 0 ? sr::backward : sr::forward, spm::driving);
}

bool Stage::breaks(const std::string& clause) const {
  const auto& all = monitor_->breaches();
  return std::any_of(all.begin(), all.end(), [&](const auto& breach) { return breach.clause->id == clause; });
}

std::string Stage::breaches() const {
  std::string ids;
  for (const auto& breach : monitor_->breaches()) {
    if (std::string(breach.clause->id) == "H-17.9") {
      continue;
    }
    ids += (ids.empty() ? "" : " ") + std::string(breach.clause->id);
  }
  return ids;
}

}  // namespace stage
