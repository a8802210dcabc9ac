// The neutral rule (SB-01.8): after anything that took drive away, the stick must be seen at rest for several
// generals in a row before the chair may move again.
#pragma once

#include <stdint.h>

#include "drivers/base/grant.hpp"

namespace spm {

class Neutral {
 public:
  constexpr explicit Neutral(uint8_t proof) : proof_(proof), run_(0), is_shown_(true) {}

  // Something forbids driving right now. `is_shown`: it is one of the causes the remote is told about.
  void require(bool is_shown) {
    run_ = 0;
    seen_.withhold();
    is_shown_ = is_shown_ || is_shown;
  }

  // One general of the module that drives.
  void observe(bool is_at_rest) {
    run_ = is_at_rest ? static_cast<uint8_t>(run_ + 1) : uint8_t{0};
    is_deflected_ = !is_at_rest;
    if (run_ >= proof_) {
      run_ = proof_;
      seen_.give();
      is_shown_ = false;
    }
  }

  bool is_awaited() const { return !seen_.is_given(); }
  // The remote's "temporary drive modification" (SB-01.3): also whenever a held stick is what keeps the chair still.
  bool is_shown() const { return is_awaited() && (is_shown_ || is_deflected_); }
  bool is_intact() const { return seen_.is_intact(); }  // H-27
  // The user fault itself: the stick is held while rest is awaited (SB-01.9).
  bool is_violated() const { return is_awaited() && is_deflected_; }

 private:
  uint8_t proof_;
  uint8_t run_;
  base::Grant seen_;
  bool is_shown_;
  bool is_deflected_ = false;
};

}  // namespace spm
