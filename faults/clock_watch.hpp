// Do the two clocks agree? (H-24) Milliseconds come from one timer, microseconds from another.
//
// Goals: a clock that stands still, or is more than 1 % faster or slower than the other, is noticed: after 10 ms if it
// stands or is twice too fast, after 0.1 s at 4 %.
// Assumptions: both are of the same moment, give or take a millisecond; asked each 10 ms, at least every 30.
// Invariants: an offset that grows by less than 1 % is forgiven for ever, so that many small upsets do not add up.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace faults {

class ClockWatch {
 public:
  // How far one may be ahead of the other: the moment's grain, and a hold-up of the loop.
  static constexpr int16_t tolerance = 3000;  // microseconds
  // And by how much that is forgiven with every look: 1 % of 10 ms.
  static constexpr int16_t forgiven = 100;

  // False if they do not agree.
  bool agree(base::Instant now, base::Stamp stamp) {
    // Modulo 65.5 ms both, and so is what lies between them.
    const uint16_t apart = static_cast<uint16_t>(stamp.count() - static_cast<uint16_t>(now.count()) * 1000U);
    if (!is_anchored_) {
      is_anchored_ = true;
      anchor_ = apart;
      return true;
    }
    const int16_t drift = static_cast<int16_t>(apart - anchor_);
    if (drift > tolerance || drift < -tolerance) {
      return false;
    }
    follow(drift);
    return true;
  }

 private:
  void follow(int16_t drift) {
    const int16_t step = drift > forgiven ? forgiven : drift < -forgiven ? int16_t{-forgiven} : drift;
    anchor_ = static_cast<uint16_t>(anchor_ + static_cast<uint16_t>(step));
  }

  bool is_anchored_ = false;
  uint16_t anchor_ = 0;  // how far they were apart
};

}  // namespace faults
