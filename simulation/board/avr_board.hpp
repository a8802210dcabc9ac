// The power module as flashed: its image in a simulated ATmega1284P. README.md beside this file says what is
// modelled and how faithfully.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/board/avr_eeprom_write.hpp"
#include "simulation/board/avr_interrupt_use.hpp"
#include "simulation/board/spm_board.hpp"

namespace simulation {

struct AvrBoardOptions {
  std::string image;  // path of an ELF or, with the suffix .hex, an Intel HEX file
  std::string mcu = "atmega1284p";
  std::uint32_t frequency = 8'000'000;
  std::int32_t clock_error_ppm = 0;  // positive: the crystal runs fast
  bool watches_locks = false;        // for interrupts_off(); the same run in twice the time
};

// What only a simulated chip can tell, besides what every board does.
class AvrBoard : public SpmBoard {
 public:
  // Address of a variable or function; nothing for a HEX file, which has no symbols.
  virtual std::optional<std::uint32_t> address_of(const std::string& symbol) const = 0;
  virtual std::uint8_t ram(std::uint16_t address) const = 0;

  // The lowest address that the stack has reached since power-on, found by the garbage it has overwritten.
  // Nothing without symbols.
  virtual std::optional<std::uint16_t> stack_low_water() const = 0;
  // The byte that is being written into the EEPROM at this moment; and a supply that fails at this moment and leaves
  // that byte as `left`: what a cell holds after half an erase or half a write, nobody promises.
  virtual std::optional<EepromWrite> eeprom_write() const = 0;
  virtual void cut_power(std::uint8_t left, Time now) = 0;

  virtual std::vector<InterruptUse> interrupt_use() const = 0;  // by vector
  // Since power-on. Nothing unless the options ask for it.
  virtual std::optional<InterruptsOff> interrupts_off() const = 0;
};

// Not powered yet, EEPROM erased. Throws std::runtime_error: an image that is missing or no image, an unknown chip.
std::unique_ptr<AvrBoard> make_avr_board_with_insight(const AvrBoardOptions& options);
std::unique_ptr<SpmBoard> make_avr_board(const AvrBoardOptions& options);

}  // namespace simulation
