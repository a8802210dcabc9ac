// When a character is worth a pass of the loop: not before as many have come as the loop has said it waits for.
// The receive interrupt calls heard(), the loop the rest, with interrupts off where noted.
#pragma once

#include <stdint.h>

namespace base {

class WakeCount {
 public:
  constexpr WakeCount() : heard_(0), taken_(0), wake_at_(0) {}

  // A character has come. True if the loop wants to know.
  bool heard() {
    ++heard_;
    return is_wanted();
  }
  void taken() { ++taken_; }

  // Nobody needs to be woken before `count` more than have been taken have come. True if they have come already, and
  // wait. Interrupts off.
  bool expect(uint8_t count) {
    wake_at_ = static_cast<uint8_t>(taken_ + count);
    return heard_ != taken_ && is_wanted();
  }

 private:
  // All counts are modulo 256, far more than can wait.
  bool is_wanted() const { return static_cast<int8_t>(heard_ - wake_at_) >= 0; }

  uint8_t heard_;
  uint8_t taken_;
  uint8_t wake_at_;
};

}  // namespace base
