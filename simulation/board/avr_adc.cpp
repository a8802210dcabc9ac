#include "simulation/board/avr_adc.hpp"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

// ADMUX
constexpr std::uint8_t left_adjust = 0x20;
constexpr std::uint8_t channel_bits = 0x1F;
constexpr std::uint8_t bandgap_channel = 0x1E;
constexpr std::uint8_t ground_channel = 0x1F;
// ADCSRA
constexpr std::uint8_t start_conversion = 0x40;
constexpr std::uint8_t conversion_flag = 0x10;

constexpr double supply_volts = 5.0;
constexpr double bandgap_volts = 1.1;
constexpr double internal_volts = 2.56;
constexpr double steps = 1024;

}  // namespace

AvrAdc::AvrAdc(AvrCore& core)
    : core_(core), avr_(core.avr()), adc_(find_module<avr_adc_t>(avr_, "adc", [](const auto&) { return true; })) {
  adc_.adts_op[0] = avr_adts_free_running;  // missing for this chip in simavr
  simavr_control_ = replace_write<&AvrAdc::write_control>(avr_, adc_.r_adcsra, *this);
  replace_read<&AvrAdc::read_low>(avr_, adc_.r_adcl, *this);
  replace_read<&AvrAdc::read_high>(avr_, adc_.r_adch, *this);
  on_signal<&AvrAdc::start>(&adc_.io.irq[ADC_IRQ_OUT_TRIGGER], *this);
  core.on_reset([this] { reset(); });
}

void AvrAdc::reset() {
  running_ = finished_ = 0;
  is_held_ = false;
}

void AvrAdc::start(std::uint32_t) {
  finished_ = running_;
  running_ = measure();
}

void AvrAdc::write_control(avr_io_addr_t address, std::uint8_t value) {
  const bool was_up = (avr_.data[address] & conversion_flag) != 0;
  const bool is_cleared = (value & conversion_flag) != 0;
  if (is_cleared) {
    core_.interrupts().withdraw(adc_.adc);
  }
  const auto others = static_cast<std::uint8_t>(value & ~conversion_flag);
  const bool is_up = was_up && !is_cleared;
  simavr_control_(avr_, address, static_cast<std::uint8_t>(is_up ? others | conversion_flag : others));
  if (is_up && core_.interrupts().is_enabled(adc_.adc) && adc_.adc.pending == 0) {
    core_.interrupts().raise(adc_.adc);
  }
}

std::uint8_t AvrAdc::read_low() {
  held_ = shown();
  is_held_ = true;
  return static_cast<std::uint8_t>(held_);
}

std::uint8_t AvrAdc::read_high() {
  const std::uint16_t result = is_held_ ? held_ : shown();
  is_held_ = false;
  return static_cast<std::uint8_t>(result >> 8);
}

std::uint16_t AvrAdc::shown() const {
  const bool is_converting = (avr_.data[adc_.r_adcsra] & start_conversion) != 0;
  const std::uint16_t result = is_converting ? finished_ : running_;
  const bool is_left = (avr_.data[adc_.r_admux] & left_adjust) != 0;
  return static_cast<std::uint16_t>(is_left ? result << 6 : result);
}

std::uint16_t AvrAdc::measure() {
  const std::uint8_t channel = avr_.data[adc_.r_admux] & channel_bits;
  double volts = 0;
  if (channel < volts_.size()) {
    volts = volts_[channel];
  } else if (channel == bandgap_channel) {
    volts = bandgap_volts;
  } else if (channel != ground_channel) {
    core_.complain("a differential channel of the ADC was used; it is not modelled");
  }
  return static_cast<std::uint16_t>(std::clamp(std::floor(volts / reference() * steps), 0.0, steps - 1));
}

double AvrAdc::reference() {
  switch (avr_.data[adc_.r_admux] >> 6) {
    case 1:
      return supply_volts;
    case 2:
      return bandgap_volts;
    case 3:
      return internal_volts;
    default:
      core_.complain("the ADC was used with the AREF pin as reference; the board has nothing there");
  }
  return supply_volts;
}

}  // namespace simulation
