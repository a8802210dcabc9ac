// How long interrupts stay off: the longest spans with SREG's I flag clear, and where in the program each began.
// Exact to the cycle, because it looks after every instruction; so a core that has one does not run in bursts.
#pragma once

#include <cstdint>

#include "simulation/board/avr_clock.hpp"
#include "simulation/board/avr_interrupt_use.hpp"
#include "simulation/board/avr_simavr.hpp"

namespace simulation {

class AvrLockWatch {
 public:
  explicit AvrLockWatch(const avr_t& avr) : avr_(avr) {}

  // The instruction at this address has just ended.
  void after_instruction(std::uint32_t address);
  // An interrupt is accepted now, and its RETI runs.
  void enter(const avr_int_vector_t& vector);
  void leave() { depth_ -= depth_ > 0 ? 1 : 0; }
  void after_reset();

  const InterruptsOff& longest() const { return longest_; }

 private:
  enum class Cause { start, program, handler };

  void begin(Cause cause, std::uint32_t from);
  void close();

  const avr_t& avr_;
  InterruptsOff longest_;
  bool is_off_ = false;
  Cause cause_ = Cause::start;
  OffSpan current_;
  Cycle since_ = 0;
  int depth_ = 0;  // of handlers
};

}  // namespace simulation
