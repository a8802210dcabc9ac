#include "spm/fuel_gauge.hpp"

#include "spm/limits.hpp"

namespace spm {

using namespace base;  // literals

void FuelGauge::step(Millivolts battery, bool is_loaded, const Settings& settings, Instant now) {
  if (now - last_ < 100_ms) {
    return;
  }
  last_ = last_ + 100_ms;
  const int32_t measured = static_cast<int32_t>(battery.count()) * 16;
  if (filtered_ == 0) {
    filtered_ = measured;
  } else if (!is_loaded) {
    filtered_ = filtered_ + (measured - filtered_) / 32;
  }
  is_settled_ = is_settled_ || now - started_ >= limits::gauge_settle;
  if (!is_settled_) {  // SB-01.1: reads 0 at first
    return;
  }
  const int32_t empty = settings[Setting::battery_empty];
  const int32_t range = settings[Setting::battery_full] - empty;
  const int32_t above = (filtered_ / 16 - empty) * (limits::gauge_full + 1);
  value_ = 0;
  for (int32_t next = range; value_ < limits::gauge_full && above >= next; next += range) {  // a division, only cheaper
    ++value_;
  }
}

}  // namespace spm
