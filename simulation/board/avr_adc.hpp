// The ADC as silicon has it: channel and voltage are taken when a conversion starts, the result appears when it
// ends, ADIF is cleared by writing one. Single-ended channels, the 1.1 V reference and 0 V; free running too.
#pragma once

#include <array>

#include "simulation/board/avr_core.hpp"

namespace simulation {

class AvrAdc {
 public:
  explicit AvrAdc(AvrCore& core);

  void set_volts(const std::array<double, 8>& volts) { volts_ = volts; }

 private:
  void reset();
  void start(std::uint32_t);
  void write_control(avr_io_addr_t address, std::uint8_t value);
  std::uint8_t read_low();
  std::uint8_t read_high();
  std::uint16_t shown() const;
  std::uint16_t measure();
  double reference();

  AvrCore& core_;
  avr_t& avr_;
  avr_adc_t& adc_;
  WriteHook simavr_control_;

  std::array<double, 8> volts_{};
  std::uint16_t running_ = 0;   // of the conversion that was started last
  std::uint16_t finished_ = 0;  // of the one before
  std::uint16_t held_ = 0;      // what ADCH belongs to, once ADCL has been read
  bool is_held_ = false;
};

}  // namespace simulation
