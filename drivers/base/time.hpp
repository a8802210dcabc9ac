// Time as two scales, each with a point and a span.
//
//   Instant, Millis   32-bit milliseconds since the clock started. For logic: wraps after 49.7 days.
//   Stamp,   Micros   16-bit microseconds. For the bus only: spans up to 65.5 ms.
//
// A point minus a point is a span; the only sensible question is `now - then >= span`, which stays
// right across the wrap as long as the true distance is below half the range (Instant) or below
// 65.5 ms (Stamp). Points cannot be compared with < and >, because that answer would be wrong there.
#pragma once

#include <stdint.h>

#include "drivers/base/units.hpp"

namespace base {

using Millis = Quantity<struct MillisTag, uint32_t>;
using Micros = Quantity<struct MicrosTag, uint16_t>;

template <typename Span>
class Point {
 public:
  using rep = typename Span::rep;

  constexpr Point() : count_(0) {}
  constexpr explicit Point(rep count) : count_(count) {}

  constexpr rep count() const { return count_; }

  constexpr Span operator-(Point earlier) const { return Span(static_cast<rep>(count_ - earlier.count_)); }
  constexpr Point operator+(Span span) const { return Point(static_cast<rep>(count_ + span.count())); }
  constexpr bool operator==(Point other) const { return count_ == other.count_; }
  constexpr bool operator!=(Point other) const { return count_ != other.count_; }

 private:
  rep count_;
};

using Instant = Point<Millis>;
using Stamp = Point<Micros>;

constexpr Millis operator"" _ms(unsigned long long count) {
  return Millis(static_cast<uint32_t>(count));
}
constexpr Millis operator"" _s(unsigned long long count) {
  return Millis(static_cast<uint32_t>(count * 1000));
}
constexpr Micros operator"" _us(unsigned long long count) {
  return Micros(static_cast<uint16_t>(count));
}

}  // namespace base
