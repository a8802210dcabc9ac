#include "simulation/powercut/module.hpp"

#include <fmt/format.h>

#include <utility>

namespace simulation::powercut {
namespace {

constexpr Time step = 500us;  // a write takes 3.4 ms, and the next one begins 4 ms after it
constexpr Time rest = 30ms;   // without a write, after the start was told: there is none to come
constexpr Time longest_start = 2s;
constexpr int started = 1;            // the event
constexpr Time byte_time = 286458ns;  // 11 bits at 38400
constexpr Time answer_time = 15ms;

constexpr double battery_volts = 25.0 / 8;  // behind the divider

// SB-04.1, SB-00.1: a remote that powers up, and one whose stick rests; each with its TF.
const std::vector<std::uint8_t> power_up{0x74, 0x82, 0x85, 0x82, 0x80, 0x88, 0xCD, 0xA0, 0x80, 0x8D, 0x0F};
const std::vector<std::uint8_t> general{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F};

constexpr std::uint8_t spm_power_up = 0x05;
constexpr std::uint8_t spm_general = 0x61;
constexpr std::uint8_t spm_settings = 0x1A;
constexpr std::uint8_t finished = 0x0F;

// SB-2.5
bool is_packet(const std::vector<std::uint8_t>& heard, std::size_t at, std::uint8_t start, std::size_t data) {
  if (at + data + 2 > heard.size() || heard[at] != start) {
    return false;
  }
  unsigned sum = 0;
  for (std::size_t i = 0; i <= data; ++i) {
    sum += heard[at + i];
  }
  return heard[at + data + 1] == (0x80U | (0x7FU - (sum & 0x7FU)));
}

bool tells_start(const EepromWrite& write) {
  return write.address >= eeprom::place_at(0) && write.address % eeprom::record_size == 0 && write.after == started;
}

// SB-05.1, SB-01.1, SB-0A.2: power-up, TF; general, settings, TF.
Answer read_answer(const std::vector<std::uint8_t>& heard) {
  constexpr std::size_t general_at = 4;
  constexpr std::size_t settings_at = general_at + 9;
  constexpr std::size_t end = settings_at + 4;
  Answer answer;
  answer.is_whole = heard.size() == end + 1 && is_packet(heard, 0, spm_power_up, 1) && heard[3] == finished &&
                    is_packet(heard, general_at, spm_general, 7) && is_packet(heard, settings_at, spm_settings, 2) &&
                    heard[end] == finished;
  if (answer.is_whole) {
    answer.limps = (heard[general_at + 1] & 0x20U) != 0;
    answer.system_state = heard[general_at + 2] & 0x0F;
    answer.speed_button_sensitivity = heard[settings_at + 1] & 0x0F;
    answer.joystick_switch_threshold = heard[settings_at + 2] & 0x7F;
  }
  return answer;
}

}  // namespace

Module::Module(const std::string& image) : board_(make_avr_board_with_insight({.image = image})) {
  Surroundings surroundings;
  surroundings.analog_volts[0] = battery_volts;
  board_->surround(surroundings);
  board_->on_speak([this](std::uint8_t value, Time) { heard_.push_back(value); });
}

bool Module::start_and_cut(const Cut& cut) {
  power_on();
  const bool is_cut = run_to_rest(&cut);
  power_off();
  return is_cut;
}

Answer Module::start() {
  power_on();
  run_to_rest(nullptr);
  say(power_up);
  run_until(now_ + answer_time);
  say(general);
  run_until(now_ + answer_time);
  const Answer answer = read_answer(heard_);
  if (board_->eeprom_write()) {
    mischief_ = "it writes while it answers";
  }
  heard_.clear();
  power_off();
  return answer;
}

std::string Module::take_mischief() {
  return std::exchange(mischief_, "");
}

void Module::power_on() {
  writes_.clear();
  heard_.clear();
  board_->power(true, now_);
  ++starts_;
}

void Module::power_off() {
  const BoardStatistics statistics = board_->statistics();
  if (!statistics.complaints.empty()) {
    mischief_ = "the chip complains: " + statistics.complaints.back();
  } else if (statistics.resets != 0) {
    mischief_ = "it was reset";
  } else if (!heard_.empty()) {
    mischief_ = "it spoke without being asked";
  }
  board_->power(false, now_);
  look_at_pins();
}

void Module::run_until(Time limit) {
  while (now_ < limit) {
    now_ = board_->run_until(limit);
  }
  look_at_pins();
}

bool Module::run_to_rest(const Cut* cut) {
  const Time began = now_;
  Time last_write = now_;
  std::optional<EepromWrite> before;
  bool has_told_start = false;  // with every start, after the settings
  while ((!has_told_start || now_ - last_write < rest) && now_ - began < longest_start) {
    run_until(now_ + step);
    const auto write = board_->eeprom_write();
    const bool is_new = write && (!before || before->address != write->address);
    before = write;
    if (write) {
      last_write = now_;
    }
    if (is_new && cut != nullptr && static_cast<int>(writes_.size()) == cut->write) {
      board_->cut_power(cut->outcome.left(*write), now_);
      return true;
    }
    if (is_new) {
      writes_.push_back(*write);
      has_told_start = has_told_start || tells_start(*write);
    }
  }
  return false;
}

void Module::say(const std::vector<std::uint8_t>& bytes) {
  for (const std::uint8_t byte : bytes) {
    run_until(now_ + byte_time);
    board_->hear({byte, false, now_});
  }
}

// H-12, H-14: nothing moves and nothing is let go, whatever the EEPROM holds.
void Module::look_at_pins() {
  const Pins pins = board_->pins();
  if (pins.bridge_enable || pins.left_duty != 0 || pins.right_duty != 0 || pins.left_brake_release ||
      pins.right_brake_release || pins.motor_relay || pins.actuator1_extend || pins.actuator1_retract ||
      pins.actuator2_extend || pins.actuator2_retract) {
    mischief_ = "an output is not safe";
  }
}

}  // namespace simulation::powercut
