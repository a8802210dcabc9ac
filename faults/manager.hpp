// Walks a table of fault rows once for each change and says what all of them together do to the chair.
//
// Goals: a fault's whole behaviour is its row; the usual case (nothing changed, nothing pending) costs next to nothing.
// Assumptions: the table lies in flash, rows in order of severity, most severe first.
// Invariants: what a row latches only its own end condition clears; nothing here looks at what a fault means; no
// flipped bit takes a latched fault away (H-27).
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
        not_stopping_(complement(Faults())),
        not_limping_(complement(Faults())),
        begun_(),
        since_(),
        summary_(),
        is_pending_(false),
        was_link_up_(false) {}

  // `present` are the conditions that hold now; `is_link_up` whether communication is (re-)established.
  // Returns the faults that began to count with this call, for the log.
  Faults update(const Row (&rows)[row_count], Faults present, bool is_link_up, base::Instant now) {
    begun_ = Faults();
    if (has_to_walk(present, is_link_up)) {
      walk(rows, present, is_link_up, now);
    }
    return begun_;
  }

  // Whether update() has anything to do.
  bool has_to_walk(Faults present, bool is_link_up) const {
    return present != present_ || is_pending_ || is_link_up != was_link_up_;
  }

  // Whether update() would find a condition that was not there before.
  bool are_new(Faults present) const { return !present.without(present_).empty(); }

  // False once a bit of what is latched has flipped (H-27): then the next update() has to mend it.
  bool is_intact() const {
    return not_stopping_ == complement(stopping_) && not_limping_ == complement(limping_) &&
           summary_.must_stop != stopping_.empty() && summary_.is_limping != limping_.empty();
  }

  void mend() { is_pending_ = true; }

  const Summary& summary() const { return summary_; }
  // Conditions that hold and have outlasted their debounce.
  Faults active() const { return counted_; }
  // Faults that stop the chair, or make it limp, right now: present or latched.
  Faults stopping() const { return stopping_; }
  Faults limping() const { return limping_; }

 private:
  static constexpr Faults with_rows() { return Faults::of_first(row_count); }
  static constexpr Faults complement(Faults faults) { return Faults::all().without(faults); }

  void walk(const Row (&rows)[row_count], Faults present, bool is_link_up, base::Instant now) {
    Summary sum;
    is_pending_ = false;
    // H-27: one of both copies is enough to go on stopping; of what has no row, nothing.
    stopping_ = (stopping_ | complement(not_stopping_)) & with_rows();
    limping_ = (limping_ | complement(not_limping_)) & with_rows();
    counted_ = counted_ & with_rows();
    // The other rows neither do anything nor begin to.
    const Faults concerned = (present & with_rows()) | counted_ | stopping_ | limping_;
    // Eight rows at a time: an AVR reckons in bytes.
    for (uint8_t part = 0; part < Faults::parts; ++part) {
      if (concerned.part(part) != 0) {
        walk_part(rows, part, concerned.part(part), present.part(part), is_link_up, now, sum);
      }
    }
    not_stopping_ = complement(stopping_);
    not_limping_ = complement(limping_);
    present_ = present;
    was_link_up_ = is_link_up;
    summary_ = sum;
  }

  void walk_part(const Row (&rows)[row_count], uint8_t part, uint8_t todo, uint8_t present, bool is_link_up,
                 base::Instant now, Summary& sum) {
    uint8_t& counted = counted_.part(part);
    uint8_t& stopping = stopping_.part(part);
    uint8_t& limping = limping_.part(part);
    uint8_t& begun = begun_.part(part);
    uint8_t i = static_cast<uint8_t>(part * 8);
    for (uint8_t bit = 1; todo != 0; bit = static_cast<uint8_t>(bit << 1), ++i) {
      if ((todo & bit) == 0) {
        continue;
      }
      todo = static_cast<uint8_t>(todo & ~bit);
      const Row& row = rows[i];  // in flash: each column is fetched where it is needed
      const bool did_count = (counted & bit) != 0;
      const bool was_present = (present_.part(part) & bit) != 0;
      const bool counts = (present & bit) != 0 && (did_count || outlasts_debounce(row, i, was_present, now));
      put(begun, bit, counts && !did_count);
      put(counted, bit, counts);
      const Stops stops = base::from_flash(row.stops);
      const bool stops_now = keeps_stopping(stops, counts, (stopping & bit) != 0, is_link_up);
      put(stopping, bit, stops_now);
      const bool limps_now = keeps_limping(base::from_flash(row.limps), counts, (limping & bit) != 0);
      put(limping, bit, limps_now);
      sum.must_stop = sum.must_stop || stops_now;
      sum.is_transient = sum.is_transient || (stops_now && stops == Stops::until_link);
      sum.is_limping = sum.is_limping || limps_now;
      if (sum.system_state == 0 && (stops_now || limps_now || counts)) {  // SB-01.9
        sum.system_state = base::from_flash(row.system_state);
      }
    }
  }

  static void put(uint8_t& part, uint8_t bit, bool is_in) {
    part = static_cast<uint8_t>(is_in ? part | bit : part & ~bit);
  }

  // For a condition that is present and does not count yet.
  bool outlasts_debounce(const Row& row, uint8_t i, bool was_present, base::Instant now) {
    const base::Millis debounce(base::from_flash(row.debounce_ms));
    if (debounce == base::Millis(0)) {
      return true;
    }
    base::Instant& since = since_[i];
    if (!was_present) {
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

  Faults present_;
  Faults counted_;
  Faults stopping_;
  Faults limping_;
  Faults not_stopping_;  // the same once more, as complements
  Faults not_limping_;
  Faults begun_;
  base::Array<base::Instant, row_count> since_;  // when a debounced condition was first present
  Summary summary_;
  bool is_pending_;  // a debounce is running
  bool was_link_up_;
};

}  // namespace faults
