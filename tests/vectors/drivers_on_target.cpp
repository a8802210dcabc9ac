// Drivers without hardware, as far as the board's group uses them. The real ones have tests of their own.
#include "drivers/analog.hpp"
#include "drivers/bridge.hpp"
#include "drivers/clock.hpp"
#include "drivers/power_latch.hpp"
#include "drivers/serial.hpp"
#include "drivers/signals.hpp"
#include "drivers/store.hpp"
#include "drivers/watchdog.hpp"
#include "tests/vectors/drivers.hpp"

namespace {

uint16_t measured;
drivers::bridge::Motion moved;

}  // namespace

namespace vectors {

void measure(uint16_t raw) {
  measured = raw;
}

const drivers::bridge::Motion& motion() {
  return moved;
}

}  // namespace vectors

namespace drivers {

namespace analog {
void start() {}
void scan() {}
uint16_t raw(Channel) {
  return measured;
}
bool is_ready() {
  return true;
}
}  // namespace analog

namespace bridge {
void start() {}
void apply(const Motion& motion) {
  moved = motion;
}
}  // namespace bridge

namespace clock {
void start() {}
base::Stamp stamp() {
  return base::Stamp();
}
void tick_twice(bool) {}
}  // namespace clock

namespace power_latch {
void hold() {}
void release() {}
}  // namespace power_latch

namespace serial {
void start() {}
bool take(base::HeardByte&) {
  return false;
}
void expect(uint8_t) {}

void arm(uint8_t, base::Span<const uint8_t>) {}
void speak(base::Span<const uint8_t>) {}
void hush() {}
base::TurnSender::State state() {
  return base::TurnSender::State::idle;
}
bool take_clash() {
  return false;
}
}  // namespace serial

namespace signals {
void start() {}
void apply(const Switched&) {}
Sensed sense() {
  return Sensed();
}
bool is_awake() {
  return false;
}
}  // namespace signals

namespace store {
uint8_t read(uint16_t) {
  return 0xFF;
}
}  // namespace store

namespace watchdog {
void start() {}
ResetCause reset_cause() {
  return ResetCause::power_on;
}
}  // namespace watchdog

}  // namespace drivers
