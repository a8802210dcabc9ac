// A board's crystal: which CPU cycle happens when.
#pragma once

#include <cstdint>

#include "simulation/time.hpp"

namespace simulation {

using Cycle = std::uint64_t;

class AvrClock {
 public:
  // `error_ppm` is how much too fast the crystal runs.
  AvrClock(std::uint32_t frequency, std::int32_t error_ppm) : micro_hertz_(Wide{frequency} * (million + error_ppm)) {}

  // From now on `cycle` is what happens at `time`.
  void anchor(Time time, Cycle cycle) {
    origin_time_ = time;
    origin_cycle_ = cycle;
  }

  // The first cycle that does not lie before `time`; time_of(cycle_at(time)) >= time.
  Cycle cycle_at(Time time) const {
    if (time <= origin_time_) {
      return origin_cycle_;
    }
    const Wide product = Wide{(time - origin_time_).count()} * micro_hertz_;
    return origin_cycle_ + static_cast<Cycle>((product + scale - 1) / scale);
  }

  Time time_of(Cycle cycle) const { return origin_time_ + span_of(cycle - origin_cycle_); }

  Time span_of(Cycle cycles) const { return Time(static_cast<std::int64_t>(Wide{cycles} * scale / micro_hertz_)); }

 private:
  __extension__ using Wide = __int128;  // nanoseconds times micro-hertz do not fit into 64 bits
  static constexpr Wide million = 1'000'000;
  static constexpr Wide scale = 1'000'000'000 * million;

  Wide micro_hertz_;
  Time origin_time_{};
  Cycle origin_cycle_ = 0;
};

}  // namespace simulation
