// A set of the values of one enum, as bits. The enum's values count up from 0 and stay below the number of bits.
// Questions about one item are always inlined: with the item known they are a bit operation, where an AVR would
// otherwise shift in a loop.
#pragma once

#include <stdint.h>

namespace faults {

template <typename Item, typename BitsOf = uint16_t>
class Set {
 public:
  using Bits = BitsOf;

  constexpr Set() : bits_(0) {}

  __attribute__((always_inline)) static constexpr Set of(Item item) {
    return Set(static_cast<Bits>(Bits{1} << static_cast<uint8_t>(item)));
  }
  static constexpr Set all() { return Set(static_cast<Bits>(~Bits{0})); }
  // The first `count` of them; count < the number of bits.
  static constexpr Set of_first(uint8_t count) { return Set(static_cast<Bits>((Bits{1} << count) - 1)); }
  // Walking all items in order, without a shift by a variable: first(), then next() of each.
  static constexpr Set first() { return Set(1); }
  constexpr Set next() const { return Set(static_cast<Bits>(bits_ << 1)); }

  __attribute__((always_inline)) constexpr bool has(Item item) const { return has(of(item)); }
  constexpr bool has(Set some) const { return (bits_ & some.bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool operator==(Set other) const { return bits_ == other.bits_; }
  constexpr bool operator!=(Set other) const { return bits_ != other.bits_; }

  constexpr Set operator|(Set other) const { return Set(static_cast<Bits>(bits_ | other.bits_)); }
  constexpr Set operator&(Set other) const { return Set(static_cast<Bits>(bits_ & other.bits_)); }
  constexpr Set without(Set other) const { return Set(static_cast<Bits>(bits_ & ~other.bits_)); }

  __attribute__((always_inline)) void put(Item item, bool is_in) { put(of(item), is_in); }
  __attribute__((always_inline)) void put(Set some, bool is_in) {
    bits_ = static_cast<Bits>(is_in ? (bits_ | some.bits_) : (bits_ & ~some.bits_));
  }
  void add(Item item) { put(item, true); }

  constexpr Bits bits() const { return bits_; }

  // Eight items at a time, the first eight are part 0.
  static constexpr uint8_t parts = sizeof(Bits);
  uint8_t part(uint8_t index) const { return reinterpret_cast<const uint8_t*>(&bits_)[index]; }
  uint8_t& part(uint8_t index) { return reinterpret_cast<uint8_t*>(&bits_)[index]; }
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "parts are bytes in memory");

 private:
  constexpr explicit Set(Bits bits) : bits_(bits) {}

  Bits bits_;
};

}  // namespace faults
