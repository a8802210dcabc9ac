// Interrupt flags of timers, INTn pins and pin changes as silicon has them: a flag that is up when its
// interrupt is enabled fires at once, and writing one to a flag register clears just that flag.
#pragma once

#include <map>
#include <vector>

#include "simulation/board/avr_core.hpp"

namespace simulation {

class AvrFlags {
 public:
  explicit AvrFlags(AvrCore& core);

 private:
  void adopt(avr_int_vector_t& vector);
  void write_mask(avr_io_addr_t address, std::uint8_t value);
  void write_flags(avr_io_addr_t address, std::uint8_t value);

  AvrCore& core_;
  std::vector<avr_int_vector_t*> vectors_;
  std::map<avr_io_addr_t, WriteHook> masks_;  // what simavr does on a write to TIMSKn, EIMSK, PCICR
};

}  // namespace simulation
