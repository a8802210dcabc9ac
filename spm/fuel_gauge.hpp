// How full the battery looks: the voltage it would have without load, slowly filtered, on the bus's scale of 0 to 18
// (SB-01.1). It sinks at once and rises only by what it has gained beyond a whole step: no battery fills up while it is
// driven, and none is seen to bounce.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"
#include "drivers/base/units.hpp"
#include "spm/settings.hpp"

namespace spm {

class FuelGauge {
 public:
  void start(base::Instant now) { started_ = last_ = now; }
  // At least every 100 ms, which is its raster.
  void step(base::Millivolts at_rest, const Settings& settings, base::Instant now);

  uint8_t value() const { return value_; }

 private:
  base::Instant started_;
  base::Instant last_;
  bool is_settled_ = false;
  int32_t filtered_ = 0;  // millivolts, times 16; 0 = not yet begun
  uint8_t value_ = 0;
};

}  // namespace spm
