// One turn on a half-duplex line: waits for its starting signal, hands its bytes out one at a time,
// and checks that each comes back from the line as it was sent.
//
// Goals: the answer starts right after the terminator has ended, however busy the loop is; a
// contended line is left at once.
// Assumptions: the transmit interrupt calls next(), the receive interrupt calls hear(); the loop
// calls the rest while both are locked out, except where noted.
// Invariants: bytes_ does not change while armed or speaking; nothing is handed out after an echo
// differed (SB-1.4); what is heard while speaking never reaches the caller as received data.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"

namespace base {

class TurnSender {
 public:
  // The longest turn: general 9, HHP data 10, settings 4, TF (SB-2.2).
  static constexpr uint8_t capacity = 24;

  enum class State : uint8_t {
    idle,      // nothing to say
    armed,     // waits for the terminator
    speaking,  // from the decision to start until the last stop bit has left
  };

  enum class Heard : uint8_t {
    data,   // somebody else's character: pass it on
    start,  // the terminator we waited for: pass it on, then begin to send
    echo,   // our own, as sent: drop it
    clash,  // our own, but changed: drop it, send nothing more
  };

  constexpr TurnSender()
      : bytes_(),
        size_(0),
        sent_(0),
        echoed_(0),
        terminator_(0),
        last_(0),
        is_last_clean_(false),
        state_(State::idle),
        clashed_(false) {}

  State state() const { return state_; }

  // Forgets what was armed or not yet sent. The character in the shift register still leaves.
  void hush() {
    size_ = sent_;
    if (state_ != State::speaking || sent_ == 0) {
      state_ = State::idle;
    }
  }

  // Copies a turn in. Only after hush() and while idle; needs no lock, because nothing reads
  // the bytes of an idle sender. Longer turns are cut at `capacity`: callers stay below it.
  void load(Span<const uint8_t> turn) {
    const uint8_t size = turn.size() < capacity ? turn.size() : capacity;
    for (uint8_t i = 0; i < size; ++i) {
      bytes_[i] = turn[i];
    }
    size_ = size;
    sent_ = 0;
    echoed_ = 0;
  }

  // True if the terminator is the last thing that was heard, a moment ago (`is_recent`): the turn has begun, although
  // it came late.
  bool arm(uint8_t terminator, bool is_recent) {
    if (is_recent && is_last_clean_ && last_ == terminator) {
      begin();
      return true;
    }
    terminator_ = terminator;
    state_ = State::armed;
    return false;
  }

  void begin() {
    state_ = State::speaking;
    is_last_clean_ = false;
  }

  // A character came from the line.
  Heard hear(uint8_t value, bool is_spoiled) {
    if (state_ == State::armed && value == terminator_ && !is_spoiled) {
      begin();
      return Heard::start;
    }
    if (state_ != State::speaking || sent_ == 0) {
      last_ = value;
      is_last_clean_ = !is_spoiled;
      return Heard::data;
    }
    if (!clashed_ && echoed_ < sent_ && value == bytes_[echoed_] && !is_spoiled) {
      ++echoed_;
      return Heard::echo;
    }
    clashed_ = true;  // SB-1.4: the rest of the turn is abandoned
    size_ = sent_;
    return Heard::clash;
  }

  // The next byte to send; false when there is none (left).
  bool next(uint8_t& value) {
    if (state_ != State::speaking || sent_ >= size_) {
      return false;
    }
    value = bytes_[sent_++];
    return true;
  }

  bool has_more() const { return state_ == State::speaking && sent_ < size_; }

  // The last stop bit has left.
  void finished() {
    state_ = State::idle;
    sent_ = 0;
  }

  // Whether an echo has differed since take_clash() was last asked.
  bool has_clashed() const { return clashed_; }
  // Whether an echo differed since this was last asked.
  bool take_clash() {
    const bool clashed = clashed_;
    clashed_ = false;
    return clashed;
  }

 private:
  Array<uint8_t, capacity> bytes_;
  uint8_t size_;
  uint8_t sent_;
  uint8_t echoed_;
  uint8_t terminator_;
  uint8_t last_;  // somebody else's last character
  bool is_last_clean_;
  State state_;
  bool clashed_;
};

}  // namespace base
