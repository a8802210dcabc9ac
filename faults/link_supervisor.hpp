// Is the link alive? Counts corrupt packets in a row, watches the age of the last good message, and says when a
// lost link has proved itself again.
//
// Goals: one bad moment may take the link away, only several good messages in a row bring it back.
// Assumptions: events arrive in the order they were heard; poll() at least every millisecond.
// Invariants: is_up() is false from the moment a limit is passed until `proof` good messages have followed.
#pragma once

#include <stdint.h>

#include "drivers/base/grant.hpp"
#include "drivers/base/time.hpp"

namespace faults {

class LinkSupervisor {
 public:
  struct Limits {
    uint8_t corrupt_run;   // so many corrupt packets in a row lose the link
    base::Micros silence;  // a good message this old loses the link; at most 63 ms
    uint8_t proof;         // so many good messages in a row re-establish it
  };

  constexpr explicit LinkSupervisor(Limits limits)
      : limits_(limits),
        coarse_silence_(limits.silence.count() / 1000U),
        corrupt_run_(0),
        good_run_(0),
        is_watching_(false),
        is_silent_(false),
        is_near_silence_(false),
        up_(true) {}

  // A good message of the watched sender; the first one starts the watch for silence.
  void message(base::Instant now, base::Stamp at);
  // Any other sound packet: ends a run of corrupt ones, proves nothing.
  void sound() { corrupt_run_ = 0; }
  void corrupt();
  // The peer started over: lost, and silence is not watched until its next good message.
  void restarted();
  // Bus idle mode: silence is expected from now on.
  void rest();
  // True if the link has fallen silent with this call.
  bool poll(base::Instant now, base::Stamp at);

  // Silence is near enough that a millisecond is too coarse a grain for poll().
  bool is_near_silence() const { return is_near_silence_; }
  bool has_corrupt_run() const { return corrupt_run_ >= limits_.corrupt_run; }
  bool is_silent() const { return is_silent_; }
  bool is_up() const { return up_.is_given(); }
  bool is_intact() const { return up_.is_intact(); }  // H-27

 private:
  void lose() {
    up_.withhold();
    good_run_ = 0;
  }

  Limits limits_;
  base::Millis coarse_silence_;
  uint8_t corrupt_run_;
  uint8_t good_run_;
  bool is_watching_;
  bool is_silent_;
  bool is_near_silence_;
  base::Grant up_;
  base::Instant last_;      // when the last good message came, coarse
  base::Stamp last_stamp_;  // and fine
};

}  // namespace faults
