// Walks a table of fault rows once for each change and says what all of them together do to the chair.
//
// Goals: a fault's whole behaviour is its row; the usual case (nothing changed, nothing pending) costs next to nothing.
// Assumptions: the table lies in flash, rows in order of severity, most severe first.
// Invariants: what a row latches only its own end condition clears; nothing here looks at what a fault means.
#pragma once

#include <stdint.h>

#include "drivers/base/flash.hpp"
#include "drivers/base/span.hpp"
#include "drivers/base/time.hpp"
#include "faults/row.hpp"
#include "faults/set.hpp"

namespace faults {

// What the faults of this moment add up to.
struct Summary {
  bool is_transient = false;  // an until_link stop is in force (SB-2.14, SB-2.15)
  bool must_stop = false;     // any stop is in force, TRANSIENT included
  bool is_limping = false;
  uint8_t system_state = 0;
};

template <typename Fault, uint8_t row_count, typename Bits = uint16_t>
class Manager {
 public:
  using Faults = Set<Fault, Bits>;

  constexpr Manager()
      : present_(),
        counted_(),
        stopping_(),
        limping_(),
        begun_(),
        since_(),
        summary_(),
        is_pending_(false),
        was_link_up_(false) {}

  // `present` are the conditions that hold now; `is_link_up` whether communication is (re-)established.
  // Returns the faults that began to count with this call, for the log.
  Faults update(const Row (&rows)[row_count], Faults present, bool is_link_up, base::Instant now) {
    begun_ = Faults();
    if (present != present_ || is_pending_ || is_link_up != was_link_up_) {
      walk(rows, present, is_link_up, now);
    }
    return begun_;
  }

  // Whether update() would find a condition that was not there before.
  bool are_new(Faults present) const { return !present.without(present_).empty(); }

  const Summary& summary() const { return summary_; }
  // Conditions that hold and have outlasted their debounce.
  Faults active() const { return counted_; }
  // Faults that stop the chair, or make it limp, right now: present or latched.
  Faults stopping() const { return stopping_; }
  Faults limping() const { return limping_; }

 private:
  void walk(const Row (&rows)[row_count], Faults present, bool is_link_up, base::Instant now) {
    Summary sum;
    is_pending_ = false;
    // The other rows neither do anything nor begin to.
    Bits concerned = (present | counted_ | stopping_ | limping_).bits();  // that of row i is the lowest
    Faults fault = Faults::first();
    uint8_t i = 0;
    if ((concerned & 0xFFU) == 0) {  // usually none of the eight most severe: they cost one step together
      concerned = static_cast<Bits>(concerned >> 8);
      fault = fault.eight_on();
      i = 8;
    }
    for (; i < row_count && concerned != 0; ++i, fault = fault.next(), concerned = static_cast<Bits>(concerned >> 1)) {
      if ((concerned & 1U) == 0) {
        continue;
      }
      const Row& row = rows[i];  // in flash: each column is fetched where it is needed
      const bool counts = present.has(fault) && outlasts_debounce(row, fault, now);
      begun_.put(fault, counts && !counted_.has(fault));
      counted_.put(fault, counts);
      const Stops stops = base::from_flash(row.stops);
      stopping_.put(fault, keeps_stopping(stops, counts, stopping_.has(fault), is_link_up));
      limping_.put(fault, keeps_limping(base::from_flash(row.limps), counts, limping_.has(fault)));
      add_up(row, stops, fault, sum);
    }
    present_ = present;
    was_link_up_ = is_link_up;
    summary_ = sum;
  }

  // For a condition that is present.
  bool outlasts_debounce(const Row& row, Faults fault, base::Instant now) {
    if (counted_.has(fault)) {
      return true;
    }
    const base::Millis debounce(base::from_flash(row.debounce_ms));
    base::Instant& since = since_[base::from_flash(row.fault)];
    if (!present_.has(fault)) {
      since = now;
    }
    if (now - since >= debounce) {
      return true;
    }
    is_pending_ = true;
    return false;
  }

  static bool keeps_stopping(Stops stops, bool counts, bool was_stopping, bool is_link_up) {
    switch (stops) {
      case Stops::no:
        return false;
      case Stops::while_present:
        return counts;
      case Stops::until_link:
        return counts || (was_stopping && !is_link_up);  // SB-2.16
      case Stops::until_power_down:
        return counts || was_stopping;
    }
    return true;
  }

  static bool keeps_limping(Limps limps, bool counts, bool was_limping) {
    switch (limps) {
      case Limps::no:
        return false;
      case Limps::while_present:
        return counts;
      case Limps::until_power_down:
        return counts || was_limping;  // SB-2.16
    }
    return true;
  }

  void add_up(const Row& row, Stops stops, Faults fault, Summary& sum) const {
    const bool is_stopping = stopping_.has(fault);
    const bool is_limping = limping_.has(fault);
    sum.must_stop = sum.must_stop || is_stopping;
    sum.is_transient = sum.is_transient || (is_stopping && stops == Stops::until_link);
    sum.is_limping = sum.is_limping || is_limping;
    if (sum.system_state == 0 && (is_stopping || is_limping || counted_.has(fault))) {  // SB-01.9
      sum.system_state = base::from_flash(row.system_state);
    }
  }

  Faults present_;
  Faults counted_;
  Faults stopping_;
  Faults limping_;
  Faults begun_;
  base::Array<base::Instant, row_count> since_;  // when a debounced condition was first present
  Summary summary_;
  bool is_pending_;  // a debounce is running
  bool was_link_up_;
};

}  // namespace faults
