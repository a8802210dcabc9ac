// A field of a packet as data: which byte, which bits. Bit 7 of every data byte on the Shark Bus is
// a marker (SB-2.4), so fields live in bits 6 to 0 and never cross a byte.
#pragma once

#include <stdint.h>

namespace base {

struct Field {
  uint8_t byte;
  uint8_t high;
  uint8_t low;

  constexpr uint8_t mask() const { return static_cast<uint8_t>(((2U << high) - 1U) & ~((1U << low) - 1U)); }
  constexpr uint8_t maximum() const { return static_cast<uint8_t>(mask() >> low); }
};

// These are always inlined: with the field known each is a few instructions, where a call would need more, and
// would need every Field in RAM.

__attribute__((always_inline)) constexpr uint8_t read(const uint8_t* data, Field field) {
  return static_cast<uint8_t>((data[field.byte] & field.mask()) >> field.low);
}

__attribute__((always_inline)) constexpr bool is_set(const uint8_t* data, Field field) {
  return (data[field.byte] & field.mask()) != 0;
}

// Sets the field's bits; `data` must hold zeros there. Bits of `value` outside the field are dropped.
__attribute__((always_inline)) constexpr void put(uint8_t* data, Field field, uint8_t value) {
  data[field.byte] = static_cast<uint8_t>(data[field.byte] | (static_cast<uint8_t>(value << field.low) & field.mask()));
}

// A field of one bit.
__attribute__((always_inline)) constexpr void put(uint8_t* data, Field field, bool is_on) {
  if (is_on) {
    data[field.byte] = static_cast<uint8_t>(data[field.byte] | field.mask());
  }
}

}  // namespace base
