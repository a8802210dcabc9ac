#include "simulation/board/host_board.hpp"

#include <algorithm>
#include <optional>

#include "drivers/host/machine.hpp"
#include "drivers/power_latch.hpp"
#include "simulation/board/host_transmitter.hpp"
#include "simulation/board/inside_view.hpp"
#include "spm/firmware.hpp"

namespace simulation {
namespace {

using drivers::host::Machine;
using drivers::watchdog::ResetCause;

// From reset to the start of the chip's clocks, so that its milliseconds and ours fall together.
constexpr Time start_up = 1318us;
constexpr Time loop_grain = 500us;  // timer 3; every second one comes with timer 0's millisecond
constexpr int grains_of_a_millisecond = 2;
constexpr Time from_receipt_to_silence = 3045us;  // as drivers/avr/serial.cpp

std::uint16_t raw_of(double volts) {
  constexpr double full_scale = 5.0;
  constexpr double steps = 1024;
  return static_cast<std::uint16_t>(std::clamp(volts / full_scale * steps, 0.0, steps - 1));
}

ResetCause cause_of(ResetKind kind) {
  switch (kind) {
    case ResetKind::power_on:
      return ResetCause::power_on;
    case ResetKind::external:
      return ResetCause::external;
    case ResetKind::brown_out:
      return ResetCause::brown_out;
    case ResetKind::watchdog:
      return ResetCause::watchdog;
  }
  return ResetCause::unknown;
}

class HostBoard final : public SpmBoard, public InsideView {
 public:
  std::string name() const override { return "host"; }

  void power(bool on, Time now) override {
    if (on && !is_powered_) {
      resets_ = 0;
      start(ResetKind::power_on, now);
    }
    is_powered_ = on;
  }

  bool is_powered() const override { return is_powered_; }

  void reset(ResetKind kind, Time now) override {
    if (is_powered_) {
      ++resets_;
      start(kind, now);
    }
  }

  Time run_until(Time limit) override {
    while (is_powered_) {
      const Time next = std::min({next_grain_, silence_due_, transmitter_.due()});
      if (next > limit) {
        break;
      }
      if (next == next_grain_) {
        run_grain();
      } else if (next == silence_due_) {
        silence_due_ = Time::max();
        set_stamp(next);
        pass(next);
      } else if (const auto value = transmitter_.act()) {
        if (speak_) {
          speak_(*value, next);
        }
        return next;
      }
    }
    return limit;
  }

  void hear(const Reception& reception) override {
    if (!is_powered_) {
      return;
    }
    set_stamp(reception.at);
    const bool is_somebody_elses = machine_.hear(reception.value, reception.framing_error);
    transmitter_.follow(reception.at, HostTransmitter::from_receipt_to_answer);
    if (is_somebody_elses) {
      silence_due_ = reception.at + from_receipt_to_silence;
    }
    if (machine_.is_loop_called) {
      machine_.is_loop_called = false;
      pass(reception.at);
    }
  }

  void surround(const Surroundings& surroundings) override {
    surroundings_ = surroundings;
    sense();
  }

  Pins pins() const override;
  Time bit_time() const override { return HostTransmitter::bit; }
  void on_speak(Speak speak) override { speak_ = std::move(speak); }

  std::vector<std::uint8_t> eeprom() const override { return {machine_.eeprom.begin(), machine_.eeprom.end()}; }
  void set_eeprom(const std::vector<std::uint8_t>& contents) override {
    std::copy_n(contents.begin(), std::min(contents.size(), machine_.eeprom.size()), machine_.eeprom.begin());
  }

  Inside inside() const override { return {firmware_.core().inhibits(), firmware_.core().active_faults()}; }

  BoardStatistics statistics() const override {
    BoardStatistics statistics;
    statistics.resets = resets_;
    return statistics;
  }

 private:
  // From reset to the first turn of the loop.
  void start(ResetKind kind, Time now) {
    const auto eeprom = machine_.eeprom;
    machine_ = Machine();
    machine_.eeprom = eeprom;
    machine_.reset_cause = cause_of(kind);
    transmitter_ = HostTransmitter(machine_.sender);
    firmware_ = spm::Firmware();
    started_ = now + start_up;
    next_grain_ = started_ + loop_grain;
    silence_due_ = Time::max();
    grain_ = 0;
    sense();
    drivers::host::select(machine_);
    drivers::power_latch::hold();  // SB-1.2
    firmware_.start();
    pass(now);
  }

  void run_grain() {
    const Time now = next_grain_;
    next_grain_ += loop_grain;
    const bool is_tick = ++grain_ == grains_of_a_millisecond;
    if (is_tick) {
      grain_ = 0;
      machine_.now = machine_.now + base::Millis(1);
    }
    if (is_tick || machine_.is_ticking_twice) {
      set_stamp(now);
      pass(now);
    }
  }

  void pass(Time now) {
    drivers::host::select(machine_);
    firmware_.pass();
    transmitter_.follow(now, HostTransmitter::soon);
  }

  void set_stamp(Time now) { machine_.stamp = base::Stamp(static_cast<std::uint16_t>((now - started_) / 1us)); }

  void sense() {
    machine_.wake = surroundings_.wake;
    machine_.sensed.dci_slowdown = surroundings_.dci_slowdown;
    machine_.sensed.lighting_fitted = surroundings_.lighting_fitted;
    std::transform(surroundings_.analog_volts.begin(), surroundings_.analog_volts.end(), machine_.analog_raw.begin(),
                   raw_of);
  }

  Machine machine_;
  spm::Firmware firmware_;
  HostTransmitter transmitter_{machine_.sender};
  Surroundings surroundings_;
  Speak speak_;
  bool is_powered_ = false;
  std::uint32_t resets_ = 0;
  Time started_{};
  Time next_grain_{};
  Time silence_due_ = Time::max();
  int grain_ = 0;
};

Pins HostBoard::pins() const {
  Pins pins;
  if (!is_powered_) {
    return pins;
  }
  const auto& motion = machine_.motion;
  const auto& switched = machine_.switched;
  pins.power_latch = machine_.latch_held;
  pins.bridge_enable = motion.bridge_enabled;
  pins.motor_relay = motion.relay_closed;
  pins.left_forward = motion.left.is_forward;
  pins.right_forward = motion.right.is_forward;
  pins.left_brake_release = motion.left_brake_released;
  pins.right_brake_release = motion.right_brake_released;
  pins.left_indicator = switched.left_indicator;
  pins.right_indicator = switched.right_indicator;
  pins.headlight = switched.headlight;
  pins.actuator1_extend = switched.actuator1_extend;
  pins.actuator1_retract = switched.actuator1_retract;
  pins.actuator2_extend = switched.actuator2_extend;
  pins.actuator2_retract = switched.actuator2_retract;
  pins.status_led = switched.status_led;
  pins.left_duty = motion.left.duty;
  pins.right_duty = motion.right.duty;
  return pins;
}

}  // namespace

std::unique_ptr<SpmBoard> make_host_board() {
  return std::make_unique<HostBoard>();
}

}  // namespace simulation
