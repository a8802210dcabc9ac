#include "drivers/bridge.hpp"

#include <avr/io.h>

#include "drivers/avr/board_spm.hpp"

namespace drivers {
namespace bridge {

namespace {

// Timer 1, fast PWM 9 bit (mode 6) without prescaler: 15.6 kHz.
constexpr uint8_t mode_a = _BV(WGM11);
constexpr uint8_t mode_b = _BV(WGM12) | _BV(CS10);

uint16_t sane(uint16_t duty) {
  return duty <= full_duty ? duty : uint16_t{0};
}

// Off first, on last: between the two, direction and duty may change.
void switch_off(const Motion& motion) {
  if (!motion.bridge_enabled) {
    avr::BridgeEnable::clear();
  }
  if (!motion.relay_closed) {
    avr::MotorRelay::clear();
  }
}

void set_duties(uint16_t left, uint16_t right) {
  OCR1A = left;
  OCR1B = right;
  // At compare value 0 the timer would still make a spike of one cycle, so a motor without duty is disconnected
  // from it and rests on its port bit, which is low.
  TCCR1A = static_cast<uint8_t>(mode_a | (left != 0 ? _BV(COM1A1) : 0) | (right != 0 ? _BV(COM1B1) : 0));
  TCCR1B = mode_b;
}

void make_outputs() {
  avr::PwmLeft::clear();
  avr::PwmRight::clear();
  avr::write_directions();
}

}  // namespace

void start() {
  apply(Motion());
}

void apply(const Motion& motion) {
  switch_off(motion);
  avr::LeftForward::write(motion.left.is_forward);
  avr::RightForward::write(motion.right.is_forward);
  set_duties(sane(motion.left.duty), sane(motion.right.duty));
  avr::LeftBrakeRelease::write(motion.left_brake_released);
  avr::RightBrakeRelease::write(motion.right_brake_released);
  avr::MotorRelay::write(motion.relay_closed);
  avr::BridgeEnable::write(motion.bridge_enabled);
  make_outputs();
}

}  // namespace bridge
}  // namespace drivers
