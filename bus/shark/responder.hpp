// When we may speak, and what (SB-2.7, SB-2.12, SB-2.13).
//
// Goals: an answer for every turn that earned one, none for any other, never in somebody else's slot.
// Assumptions: the transmitter, once armed, begins by itself at the next clean TF; has_begun says whether it did.
// Invariants: one answer at most for each heard turn; a turn that earned none ends in silence.
#pragma once

#include <stdint.h>

#include "bus/shark/turn.hpp"
#include "drivers/base/time.hpp"

namespace bus {
namespace shark {

// What the transmitter shall do with turn().
enum class Speech : uint8_t {
  as_it_is,  // nothing new
  arm,       // speak right after the next TF
  speak,     // speak now
  hush,      // forget what waits or is left
  cut,       // and switch the transmitter off: it does not come to an end (H-30)
};

class Responder {
 public:
  // The turn being heard holds what deserves an answer: fill the turn, then close() it.
  Turn& open() {
    turn_.open();
    return turn_;
  }
  void close() {
    turn_.close();
    is_earned_ = true;
    speech_ = Speech::arm;
  }

  // The turn being heard is over, since `age`. False if an answer was due but its time has passed.
  bool finish(bool has_begun, base::Micros age, base::Micros latest) {
    const bool is_due = is_earned_ && !has_begun;
    is_earned_ = false;
    if (!is_due) {
      return true;
    }
    speech_ = age <= latest ? Speech::speak : Speech::hush;
    return age <= latest;
  }

  // No communication is possible (SB-1.3).
  void hush() {
    is_earned_ = false;
    speech_ = Speech::hush;
  }

  // The transmitter is stuck (H-30).
  void cut() {
    is_earned_ = false;
    speech_ = Speech::cut;
  }

  // The turn being heard will be answered.
  bool is_earned() const { return is_earned_; }

  // At the beginning of a step: nothing new to say yet.
  void begin_step() { speech_ = Speech::as_it_is; }
  Speech speech() const { return speech_; }
  // Something is to be said with this step.
  bool has_answer() const { return speech_ == Speech::arm || speech_ == Speech::speak; }
  const Turn& turn() const { return turn_; }

 private:
  Turn turn_;
  bool is_earned_ = false;
  Speech speech_ = Speech::as_it_is;
};

}  // namespace shark
}  // namespace bus
