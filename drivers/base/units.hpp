// Numbers that know what they count. A Quantity holds an integer and a tag; two quantities meet in
// an expression only if their tags agree, and a bare number never becomes one by accident.
// On avr-gcc a Quantity compiles to the same instructions as the integer it holds.
#pragma once

#include <stdint.h>

namespace base {

template <typename Tag, typename Rep>
class Quantity {
 public:
  using rep = Rep;

  constexpr Quantity() : count_(0) {}
  constexpr explicit Quantity(Rep count) : count_(count) {}

  constexpr Rep count() const { return count_; }

  constexpr Quantity operator-() const { return Quantity(static_cast<Rep>(-count_)); }
  constexpr Quantity operator+(Quantity other) const { return Quantity(static_cast<Rep>(count_ + other.count_)); }
  constexpr Quantity operator-(Quantity other) const { return Quantity(static_cast<Rep>(count_ - other.count_)); }
  constexpr bool operator==(Quantity other) const { return count_ == other.count_; }
  constexpr bool operator!=(Quantity other) const { return count_ != other.count_; }
  constexpr bool operator<(Quantity other) const { return count_ < other.count_; }
  constexpr bool operator>(Quantity other) const { return count_ > other.count_; }
  constexpr bool operator<=(Quantity other) const { return count_ <= other.count_; }
  constexpr bool operator>=(Quantity other) const { return count_ >= other.count_; }

 private:
  Rep count_;
};

// Battery and bus voltages, 0 to 65.5 V.
using Millivolts = Quantity<struct MillivoltsTag, uint16_t>;
// Signed where a direction exists (motors), plain magnitude elsewhere; 0 to +-2000 A.
using Milliamps = Quantity<struct MilliampsTag, int32_t>;
// A share of a whole, 1000 = all of it.
using Permille = Quantity<struct PermilleTag, uint16_t>;

constexpr Millivolts operator"" _mV(unsigned long long count) {
  return Millivolts(static_cast<uint16_t>(count));
}
constexpr Milliamps operator"" _mA(unsigned long long count) {
  return Milliamps(static_cast<int32_t>(count));
}
constexpr Permille operator"" _permille(unsigned long long count) {
  return Permille(static_cast<uint16_t>(count));
}

constexpr int16_t magnitude(int16_t value) {
  return static_cast<int16_t>(value < 0 ? -value : value);
}

// The one spelled-out narrowing: the caller states that the value fits.
template <typename To, typename From>
constexpr To narrow(From value) {
  return static_cast<To>(value);
}

}  // namespace base
