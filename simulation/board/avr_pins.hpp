// The pins of the reference board: which port bit is which signal, what the chair drives, what the chip drives.
#pragma once

#include <cstdint>

#include "simulation/board/avr_core.hpp"

namespace simulation {

class AvrPins {
 public:
  explicit AvrPins(AvrCore& core);

  void drive(const Surroundings& surroundings);
  Pins read() const;

 private:
  struct Compare {
    avr_timer_comp_t* unit;
    std::uint16_t value = 0;  // as of the last write of the low byte, so never half of a new one
  };

  void move_wake_to_its_pin();
  void calm_level_interrupts();
  void reset();
  void apply();
  void drive_port(char name, std::uint8_t mask, std::uint8_t levels);
  void write_compare(avr_io_addr_t address, std::uint8_t value);
  template <char name>
  void toggle(avr_io_addr_t address, std::uint8_t value);
  std::uint16_t duty(const Compare& compare) const;
  std::uint8_t driven_high(char port) const;
  avr_ioport_t& port(char name) const { return *ports_[name - 'A']; }

  AvrCore& core_;
  avr_t& avr_;
  avr_ioport_t* ports_[4];
  avr_timer_t& timer_;
  avr_extint_t& interrupts_;
  Surroundings surroundings_;
  Compare left_;
  Compare right_;
  WriteHook simavr_compare_left_;
  WriteHook simavr_compare_right_;
  WriteHook simavr_toggle_[4];
};

}  // namespace simulation
