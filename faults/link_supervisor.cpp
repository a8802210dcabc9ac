#include "faults/link_supervisor.hpp"

namespace faults {

using namespace base;  // literals

void LinkSupervisor::message(Instant now, Stamp at) {
  corrupt_run_ = 0;
  is_watching_ = true;
  is_silent_ = false;
  last_ = now;
  last_stamp_ = at;
  if (is_up()) {
    return;
  }
  ++good_run_;
  if (good_run_ >= limits_.proof) {  // SB-2.16
    up_.give();
  }
}

void LinkSupervisor::corrupt() {
  good_run_ = 0;
  if (!has_corrupt_run()) {
    ++corrupt_run_;
  }
  if (has_corrupt_run()) {  // SB-2.14
    lose();
  }
}

void LinkSupervisor::restarted() {
  corrupt_run_ = 0;
  rest();
  lose();
}

void LinkSupervisor::rest() {
  is_watching_ = false;
  is_silent_ = false;
}

bool LinkSupervisor::poll(Instant now, Stamp at) {
  if (!is_watching_ || is_silent_) {
    is_near_silence_ = false;
    return false;
  }
  // The fine stamp decides, but it wraps after 65 ms: the coarse age says when it may be believed.
  const Millis age = now - last_;
  is_near_silence_ = age + 2_ms >= coarse_silence_;
  const bool is_fine_age_over = at - last_stamp_ >= limits_.silence && age + 1_ms >= coarse_silence_;
  if (is_fine_age_over || age >= coarse_silence_ + 2_ms) {  // SB-2.15
    is_silent_ = true;
    lose();
  }
  return is_silent_;
}

}  // namespace faults
