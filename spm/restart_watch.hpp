// How often the power module has restarted without being told to. One unexpected start may happen, and the chair limps
// home; three within ten seconds will happen again, so nothing moves any more until the supply was cut (H-25).
//
// Goals: the verdict does not need a clock that runs through resets; what is kept outlives them and tells by itself
// whether it is whole.
// Assumptions: begin() once after reset, step() at least every 50 ms; bytes() is kept after either.
// Invariants: an age is never more than the true one, so a third start within 10 s is never missed; it is less by at
// most 50 ms for each start and 5 % of a second, so one after 10.3 s never counts.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"
#include "drivers/base/time.hpp"
#include "spm/inputs.hpp"

namespace spm {

class RestartWatch {
 public:
  using Bytes = base::Array<uint8_t, 4>;  // ages of the last two unexpected starts, and their complements

  // `kept` is whatever RAM held. What is not whole was lost with the supply, or by a reset in the midst of the RAM
  // test: an unexpected start then counts as the second.
  void begin(const Bytes& kept, Start start, base::Instant now);
  // True if bytes() has changed.
  bool step(base::Instant now);

  bool is_looping() const { return newest_ == locked; }
  Bytes bytes() const;

 private:
  static constexpr uint8_t unit = 50;        // milliseconds of an age
  static constexpr uint8_t within = 200;     // H-25: 10 s
  static constexpr uint8_t long_ago = 201;   // or never
  static constexpr uint8_t locked = 0xE1;    // in place of both ages: no drive until power cycle
  static constexpr uint8_t begin_takes = 3;  // from reset to begin(), 190 ms and more: rounded down

  static bool is_whole(const Bytes& kept);
  void grow_older(uint8_t units);

  uint8_t newest_ = long_ago;
  uint8_t older_ = long_ago;
  base::Instant counted_;  // up to here
};

}  // namespace spm
