// The EEPROM with its time: a write keeps it busy for 3.4 ms (erase alone or write alone 1.8 ms), and a supply
// that fails in between leaves what has happened by then: before half-time the old byte, afterwards 0xFF.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/board/avr_core.hpp"
#include "simulation/board/avr_eeprom_write.hpp"

namespace simulation {

class AvrEeprom {
 public:
  explicit AvrEeprom(AvrCore& core);

  std::vector<std::uint8_t> contents() const;
  void set_contents(const std::vector<std::uint8_t>& contents);  // the rest is erased
  void lose_power();
  // As lose_power(), but a byte that is being written becomes `left` instead of what the time says.
  void lose_power(std::uint8_t left);
  std::optional<EepromWrite> write_under_way() const;

 private:
  enum class Phase : std::uint8_t { idle, erasing, writing };
  enum class Mode : std::uint8_t { erase_and_write, erase_only, write_only };

  void reset();
  void write_control(avr_io_addr_t, std::uint8_t value);
  void begin_write();
  void read();
  avr_cycle_count_t finish_phase(avr_cycle_count_t when);
  avr_cycle_count_t close_window(avr_cycle_count_t when);
  Cycle cycles(std::uint32_t microseconds) const;
  std::uint16_t address() const;
  std::uint8_t& control() { return avr_.data[eeprom_.r_eecr]; }

  AvrCore& core_;
  avr_t& avr_;
  avr_eeprom_t& eeprom_;

  Phase phase_ = Phase::idle;
  Mode mode_ = Mode::erase_and_write;
  Cycle phase_end_ = 0;
  std::uint16_t address_ = 0;
  std::uint8_t data_ = 0;
  std::uint8_t before_ = 0;
};

}  // namespace simulation
