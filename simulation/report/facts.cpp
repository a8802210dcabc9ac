#include "simulation/report/facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation::report {
namespace {

constexpr double full_duty = 511;
// Longer than the silence after which a turn without TF is answered (SB-2.12).
constexpr Time answer_window = 5ms;

int signed_duty(std::uint16_t duty, bool forward) {
  return forward ? duty : -duty;
}

bool is_live(const Pins& pins) {
  return pins.bridge_enable && pins.motor_relay;
}

int left_drive(const Pins& pins) {
  return is_live(pins) ? signed_duty(pins.left_duty, pins.left_forward) : 0;
}

int right_drive(const Pins& pins) {
  return is_live(pins) ? signed_duty(pins.right_duty, pins.right_forward) : 0;
}

bool has_grown(int before, int now) {
  const bool has_turned_round = before * now < 0;
  return std::abs(now) > std::abs(before) || has_turned_round;
}

}  // namespace

Facts::Facts(World& world)
    : world_(world), listener_([this](const Packet& packet) { take(packet); }), sample_(), before_() {}

void Facts::on_byte(const BusByte& byte) {
  last_byte_of_[static_cast<std::size_t>(byte.sender)] = byte.start;
  last_byte_ended_at_ = std::max(last_byte_ended_at_, byte.end);
  if (byte.sender == Sender::spm) {
    hear_spm(byte);
  } else if (byte.sender == Sender::sr && !byte.lost) {
    if (!sr_until_ || byte.start - *sr_until_ > answer_window) {
      sr_from_ = byte.start;
    }
    sr_until_ = byte.end;
  }
  listener_.hear(byte);
}

void Facts::on_sample(const Sample& sample) {
  before_ = sample_;
  sample_ = sample;
  listener_.advance(sample.at);
  const bool is_turn_judged = sr_until_ && sample.at - *sr_until_ > answer_window;
  if (is_turn_judged) {
    was_answered_ = spoke_at_ && *spoke_at_ > *sr_from_;
  }
}

Anchor Facts::anchor() const {
  return {world_.now(), position(), resets()};
}

bool Facts::is_powered() const {
  return sample_.spm_powered;
}

std::uint32_t Facts::resets() const {
  return world_.board().statistics().resets;
}

bool Facts::is_driven() const {
  return left_drive(pins()) != 0 || right_drive(pins()) != 0;
}

bool Facts::has_sped_up() const {
  return has_grown(left_drive(before_.pins), left_drive(pins())) ||
         has_grown(right_drive(before_.pins), right_drive(pins()));
}

double Facts::largest_duty() const {
  return std::max(std::abs(left_drive(pins())), std::abs(right_drive(pins()))) / full_duty;
}

double Facts::position() const {
  return sample_.chair.position;
}

double Facts::speed() const {
  return sample_.chair.speed;
}

double Facts::turn_rate() const {
  return sample_.chair.turn_rate * 180 / std::numbers::pi;
}

double Facts::left_duty() const {
  return left_drive(pins()) / full_duty;
}

double Facts::right_duty() const {
  return right_drive(pins()) / full_duty;
}

double Facts::left_wheel() const {
  return sample_.chair.left_wheel;
}

double Facts::right_wheel() const {
  return sample_.chair.right_wheel;
}

bool Facts::is_cable_cut() const {
  return world_.wire().is_cut();
}

bool Facts::shows_communication_fault() const {
  return world_.remote().has_communication_fault();
}

const std::string& Facts::programmer_screen() const {
  return world_.remote().programmer.screen();
}

std::vector<std::uint8_t> Facts::eeprom() const {
  return world_.board().eeprom();
}

void Facts::hear_spm(const BusByte& byte) {
  const bool begins_to_speak = !spoke_at_ || (sr_from_ && *spoke_at_ < *sr_from_);
  if (begins_to_speak && sr_until_ && !byte.lost) {
    answer_delay_ = byte.start - *sr_until_;
    answer_began_at_ = byte.start;
  }
  spoke_at_ = byte.start;
}

void Facts::take(const Packet& packet) {
  if (packet.kind != Packet::Kind::packet) {
    return;
  }
  packets_[static_cast<std::size_t>(packet.sender)].push_back(packet);
  if (packet.sender == Sender::spm && packet.is(bus::shark::Type::spm_general) && packet.data().size() >= 7) {
    spm_general_ = packet.data();
  }
}

}  // namespace simulation::report
