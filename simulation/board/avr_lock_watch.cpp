#include "simulation/board/avr_lock_watch.hpp"

namespace simulation {

void AvrLockWatch::after_instruction(std::uint32_t address) {
  const bool is_on = avr_.sreg[S_I] != 0;
  if (is_on && is_off_) {
    close();
  } else if (!is_on && !is_off_) {
    begin(depth_ > 0 ? Cause::handler : Cause::program, address);
  }
}

void AvrLockWatch::enter(const avr_int_vector_t& vector) {
  ++depth_;
  begin(Cause::handler, static_cast<std::uint32_t>(vector.vector) * avr_.vector_size);
}

void AvrLockWatch::after_reset() {
  depth_ = 0;
  begin(Cause::start, avr_.pc);
}

void AvrLockWatch::begin(Cause cause, std::uint32_t from) {
  is_off_ = true;
  cause_ = cause;
  current_.from = from;
  since_ = avr_.cycle;
}

void AvrLockWatch::close() {
  is_off_ = false;
  current_.cycles = avr_.cycle - since_;
  const auto keep_longest = [this](OffSpan& longest) {
    longest = current_.cycles > longest.cycles ? current_ : longest;
  };
  if (cause_ == Cause::start) {
    keep_longest(longest_.at_start);
    return;
  }
  keep_longest(longest_.with_handlers);
  if (cause_ == Cause::program) {
    keep_longest(longest_.by_program);
  }
}

}  // namespace simulation
