#include "simulation/board/avr_board.hpp"

#include "simulation/board/avr_adc.hpp"
#include "simulation/board/avr_clock.hpp"
#include "simulation/board/avr_core.hpp"
#include "simulation/board/avr_eeprom.hpp"
#include "simulation/board/avr_flags.hpp"
#include "simulation/board/avr_image.hpp"
#include "simulation/board/avr_pins.hpp"
#include "simulation/board/avr_uart.hpp"

namespace simulation {
namespace {

class SimulatedChip final : public AvrBoard {
 public:
  explicit SimulatedChip(const AvrBoardOptions& options)
      : image_(load_avr_image(options.image)),
        clock_(options.frequency, options.clock_error_ppm),
        core_(options.mcu, options.frequency, image_),
        flags_(core_),
        eeprom_(core_),
        adc_(core_),
        bus_uart_(core_, '0'),
        pins_(core_) {
    if (options.watches_locks) {
      core_.watch_locks();
    }
    adc_.set_volts(Surroundings{}.analog_volts);
    bus_uart_.on_start([this](std::uint8_t value, Cycle at) {
      if (speak_) {
        speak_(value, clock_.time_of(at));
      }
    });
  }

  std::string name() const override { return "avr"; }

  void power(bool on, Time now) override {
    if (on && !is_powered_) {
      clock_.anchor(now, core_.now());
      core_.reset(ResetKind::power_on);
      core_.statistics().resets = 0;
    } else if (!on && is_powered_) {
      eeprom_.lose_power();
    }
    is_powered_ = on;
  }

  bool is_powered() const override { return is_powered_; }

  void reset(ResetKind kind, Time) override {
    if (is_powered_) {
      core_.reset(kind);
    }
  }

  Time run_until(Time limit) override {
    if (!is_powered_) {
      return limit;
    }
    core_.run(clock_.cycle_at(limit));
    return clock_.time_of(core_.now());
  }

  void hear(const Reception& reception) override {
    if (is_powered_) {
      bus_uart_.hear(reception.value, reception.framing_error);
    }
  }

  void surround(const Surroundings& surroundings) override {
    adc_.set_volts(surroundings.analog_volts);
    pins_.drive(surroundings);
  }

  Pins pins() const override { return is_powered_ ? pins_.read() : Pins{}; }
  Time bit_time() const override { return clock_.span_of(bus_uart_.bit_cycles()); }
  void on_speak(Speak speak) override { speak_ = std::move(speak); }

  std::vector<std::uint8_t> eeprom() const override { return eeprom_.contents(); }
  void set_eeprom(const std::vector<std::uint8_t>& contents) override { eeprom_.set_contents(contents); }

  BoardStatistics statistics() const override {
    BoardStatistics statistics = core_.statistics();
    statistics.cycles = core_.now();
    return statistics;
  }

  std::optional<std::uint32_t> address_of(const std::string& symbol) const override {
    return image_.address_of(symbol);
  }
  std::uint8_t ram(std::uint16_t address) const override { return core_.avr().data[address]; }

  std::optional<std::uint16_t> stack_low_water() const override {
    const auto end_of_variables = image_.address_of("_end");
    if (!end_of_variables) {
      return std::nullopt;
    }
    auto address = static_cast<std::uint16_t>(*end_of_variables);
    while (address < core_.avr().ramend && ram(address) == AvrCore::garbage(address)) {
      ++address;
    }
    return address;
  }

  std::optional<EepromWrite> eeprom_write() const override {
    return is_powered_ ? eeprom_.write_under_way() : std::nullopt;
  }
  void cut_power(std::uint8_t left, Time now) override {
    if (is_powered_) {
      eeprom_.lose_power(left);
    }
    power(false, now);
  }

  std::vector<InterruptUse> interrupt_use() const override { return core_.interrupts().uses(); }

  std::optional<InterruptsOff> interrupts_off() const override {
    const AvrLockWatch* watch = core_.lock_watch();
    return watch == nullptr ? std::nullopt : std::optional(watch->longest());
  }

 private:
  AvrImage image_;
  AvrClock clock_;
  AvrCore core_;
  AvrFlags flags_;
  AvrEeprom eeprom_;
  AvrAdc adc_;
  AvrUart bus_uart_;
  AvrPins pins_;
  Speak speak_;
  bool is_powered_ = false;
};

}  // namespace

std::unique_ptr<AvrBoard> make_avr_board_with_insight(const AvrBoardOptions& options) {
  return std::make_unique<SimulatedChip>(options);
}

std::unique_ptr<SpmBoard> make_avr_board(const AvrBoardOptions& options) {
  return make_avr_board_with_insight(options);
}

}  // namespace simulation
