#include "spm/board.hpp"

#include "drivers/analog.hpp"
#include "drivers/bridge.hpp"
#include "drivers/clock.hpp"
#include "drivers/power_latch.hpp"
#include "drivers/serial.hpp"
#include "drivers/signals.hpp"
#include "drivers/store.hpp"
#include "drivers/watchdog.hpp"
#include "spm/settings_block.hpp"

namespace spm {

using drivers::analog::Channel;
using drivers::watchdog::ResetCause;

namespace {

// The converter's 1024 is 5 V; the rest is the board's dividers and sensors. Each sum fits into 16 bits, because the
// AVR pays for every wider one, a thousand times a second.

// 8:1 divider: 40000 mV / 1024 = 39 1/16 a step.
base::Millivolts battery_of(uint16_t raw) {
  return base::Millivolts(static_cast<uint16_t>(raw * 39U + (raw >> 4)));
}

// 2.5 V = 0 A, 20 mV per ampere: 244 mA a step.
base::Milliamps motor_current_of(uint16_t raw) {
  const int16_t steps = static_cast<int16_t>(static_cast<int16_t>(raw) - 512);
  return base::Milliamps(static_cast<int32_t>(steps) * 244);
}

// 1 V per ampere: 5000 mA / 1024 = 5 less 15/128 a step.
base::Milliamps coil_current_of(uint16_t raw) {
  return base::Milliamps(static_cast<uint16_t>(raw * 5U - ((raw * 15U) >> 7)));
}

// SB-3.9
Start start_of(ResetCause cause) {
  switch (cause) {
    case ResetCause::watchdog:
      return Start::watchdog;
    case ResetCause::brown_out:
      return Start::brown_out;
    case ResetCause::external:
      return Start::external;
    case ResetCause::power_on:
    case ResetCause::unknown:
      break;
  }
  return Start::power_on;
}

Speaker speaker_of(base::TurnSender::State state) {
  switch (state) {
    case base::TurnSender::State::idle:
      return Speaker::idle;
    case base::TurnSender::State::armed:
      return Speaker::armed;
    case base::TurnSender::State::speaking:
      break;
  }
  return Speaker::speaking;
}

// Full demand is full duty; the sign goes to the direction pin.
drivers::bridge::Wheel wheel_of(Demand demand) {
  drivers::bridge::Wheel wheel;
  const int16_t value = demand.count();
  wheel.is_forward = value >= 0;
  const uint16_t magnitude = static_cast<uint16_t>(value < 0 ? -value : value);
  wheel.duty = static_cast<uint16_t>((magnitude - (magnitude >> 9)) >> 5);  // 511/512 of it, in steps of 2^5
  return wheel;
}
static_assert(full_demand.count() == 1 << 14 && drivers::bridge::full_duty == 511, "511/512 of 2^14 / 2^5");

void speak(const Outputs& outputs) {
  switch (outputs.speech) {
    case Speech::as_it_is:
      break;
    case Speech::arm:
      drivers::serial::arm(bus::shark::transmit_finished, outputs.turn);
      break;
    case Speech::speak:
      drivers::serial::speak(outputs.turn);
      break;
    case Speech::hush:
      drivers::serial::hush();
      break;
  }
}

void move(const Outputs& outputs) {
  drivers::bridge::Motion motion;
  motion.left = wheel_of(outputs.left);
  motion.right = wheel_of(outputs.right);
  motion.bridge_enabled = outputs.bridge_enabled;
  motion.relay_closed = outputs.relay_closed;
  motion.left_brake_released = outputs.left_brake == Brake::released;
  motion.right_brake_released = outputs.right_brake == Brake::released;
  drivers::bridge::apply(motion);
}

void switch_over(const Outputs& outputs) {
  drivers::signals::Switched switched;
  switched.left_indicator = outputs.left_indicator;
  switched.right_indicator = outputs.right_indicator;
  switched.headlight = outputs.headlight;
  switched.status_led = outputs.status_led;
  drivers::signals::apply(switched);

  if (outputs.latch == Latch::hold) {
    drivers::power_latch::hold();
  } else if (outputs.latch == Latch::release) {
    drivers::power_latch::release();
  }
}

// At least 5 cycles each: 5 ms at least, 10 at most.
constexpr uint16_t looks_at_a_busy_store = 8000;

RecordBytes stored_record(uint8_t place) {
  RecordBytes bytes;
  uint16_t address = address_of_record(place);
  for (uint8_t& byte : bytes) {
    byte = drivers::store::read(address);
    ++address;
  }
  return bytes;
}
static_assert(log_address + log_places * RecordBytes::size() == drivers::store::size, "the log ends with the EEPROM");
static_assert(settings_address + settings_copies * settings_spacing <= log_address, "settings lie before the log");

}  // namespace

void Board::start() {
  in_.start = start_of(drivers::watchdog::reset_cause());
  drivers::bridge::start();
  drivers::signals::start();
  drivers::serial::start();
  drivers::analog::start();
  drivers::clock::start();
  drivers::watchdog::start();
}

Settings Board::load(Storage& storage) {
  // A reset leaves a write that has begun to its end. Reading is refused meanwhile, and 3.4 ms of a start are to spare.
  for (uint16_t i = 0; i < looks_at_a_busy_store && drivers::store::is_busy(); ++i) {
  }
  SettingsBlock first;
  SettingsBlock second;
  for (uint8_t i = 0; i < settings_size; ++i) {
    first[i] = drivers::store::read(static_cast<uint16_t>(address_of_copy(0) + i));
    second[i] = drivers::store::read(static_cast<uint16_t>(address_of_copy(1) + i));
  }
  const LoadedSettings loaded = storage.load(first, second);
  in_.settings_lost = loaded.is_lost;
  in_.settings_copy_bad = loaded.is_copy_bad;
  return loaded.settings;
}

const Inputs& Board::sense(base::Instant now) {
  sense_bus();
  if (now != last_slow_) {
    last_slow_ = now;
    sense_next();
  }
  return in_;
}

void Board::sense_bus() {
  in_.heard_count = 0;
  while (in_.heard_count < in_.heard.size() && drivers::serial::take(in_.heard[in_.heard_count])) {
    ++in_.heard_count;
  }
  in_.stamp = drivers::clock::stamp();
  in_.speaker = speaker_of(drivers::serial::state());
  in_.echo_differed = drivers::serial::take_clash();
  in_.wake = drivers::signals::is_awake();
}

void Board::sense_next() {
  drivers::analog::scan();
  switch (turn_) {
    case 0:
      in_.battery = battery_of(drivers::analog::raw(Channel::battery));
      in_.analog_ready = drivers::analog::is_ready();
      break;
    case 1:
      in_.left_current = motor_current_of(drivers::analog::raw(Channel::left_current));
      break;
    case 2:
      in_.right_current = motor_current_of(drivers::analog::raw(Channel::right_current));
      break;
    case 3:
      in_.brake_coils = coil_current_of(drivers::analog::raw(Channel::brake_coils));
      break;
    default: {
      const drivers::signals::Sensed sensed = drivers::signals::sense();
      in_.dci_slowdown = sensed.dci_slowdown;
      in_.lighting_fitted = sensed.lighting_fitted;
    }
  }
  turn_ = turn_ < 4 ? static_cast<uint8_t>(turn_ + 1) : uint8_t{0};
}

void Board::apply(const Outputs& outputs) {
  speak(outputs);                                             // first: an answer must not wait for anything
  if (in_.heard_count != 0 || outputs.awaited != awaited_) {  // otherwise it still waits for the same character
    awaited_ = outputs.awaited;
    drivers::serial::expect(awaited_);
  }
  drivers::clock::tick_twice(outputs.is_time_pressing);
  if (!outputs.are_motors_as_before) {
    move(outputs);
  }
  if (!outputs.are_switches_as_before) {
    switch_over(outputs);
  }
}

void Board::store(Storage& storage) {
  in_.is_storing = !storage.is_at_rest();
  if (!in_.is_storing || drivers::store::is_busy()) {
    return;
  }
  EventLog& log = storage.log();
  if (log.is_looking()) {
    log.look(stored_record(log.place_to_look_at()));
    log.look(stored_record(log.place_to_look_at()));
    return;
  }
  const base::Optional<ByteWrite> write = storage.next_write();
  if (write) {
    drivers::store::write(write->address, write->value);
  }
}
static_assert(log_places % 2 == 0, "two at a time are looked at");

}  // namespace spm
