#include "spm/fuel_gauge.hpp"

#include "spm/limits.hpp"

namespace spm {

using namespace base;  // literals

void FuelGauge::step(Millivolts at_rest, const Settings& settings, Instant now) {
  if (now - last_ < 100_ms) {
    return;
  }
  last_ = last_ + 100_ms;
  const int32_t measured = static_cast<int32_t>(at_rest.count()) * 16;
  constexpr int32_t most = int32_t{UINT16_MAX} * 16;
  if (filtered_ <= 0 || filtered_ > most) {  // not begun, or no voltage at all (H-27)
    filtered_ = measured;
  } else {
    filtered_ = filtered_ + (measured - filtered_) / 32;
  }
  const bool is_first = !is_settled_;
  is_settled_ = is_settled_ || now - started_ >= limits::gauge_settle;
  if (!is_settled_) {  // SB-01.1: reads 0 at first
    return;
  }
  const int32_t empty = settings[Setting::battery_empty];
  const int32_t range = settings[Setting::battery_full] - empty;
  const int32_t above = (filtered_ / 16 - empty) * (limits::gauge_full + 1);
  uint8_t steps = 0;  // above empty, as many as there are of `range` in it: a division, only cheaper
  for (int32_t next = range; steps <= limits::gauge_full && above >= next; next += range) {
    ++steps;
  }
  if (is_first || steps < value_) {
    value_ = steps < limits::gauge_full ? steps : limits::gauge_full;
  } else if (steps > value_ + 1) {
    value_ = static_cast<uint8_t>(steps - 1);
  }
}

}  // namespace spm
