// The status LED: steady while all is well, otherwise as many flashes as the system state says, then a pause.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace spm {

class StatusLed {
 public:
  void step(uint8_t flashes, base::Instant now) {
    constexpr base::Millis half_flash(200);
    constexpr uint8_t pause = 6;  // half flashes of darkness between two groups
    if (now - last_ < half_flash) {
      return;
    }
    last_ = now;
    ++phase_;
    if (phase_ >= 2 * flashes + pause) {
      phase_ = 0;
    }
    is_on_ = flashes == 0 || (phase_ < 2 * flashes && phase_ % 2 == 0);
  }

  bool is_on() const { return is_on_; }

 private:
  base::Instant last_;
  uint8_t phase_ = 0;
  bool is_on_ = false;
};

}  // namespace spm
