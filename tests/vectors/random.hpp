// Numbers that look random and are the same everywhere and always. Draw only one in an expression: which of two
// arguments is worked out first is the compiler's choice, and the AVR's chooses otherwise.
#pragma once

#include <stdint.h>

namespace vectors {

class Random {
 public:
  explicit Random(uint32_t seed) : state_(seed) {}

  uint16_t word() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<uint16_t>(state_ >> 16);
  }
  uint32_t double_word() {
    const uint32_t high = word();
    return (high << 16) | word();
  }
  uint8_t byte() { return static_cast<uint8_t>(word() >> 8); }
  bool coin() { return (word() & 0x8000U) != 0; }
  // 0 to limit - 1.
  uint16_t below(uint16_t limit) { return static_cast<uint16_t>((static_cast<uint32_t>(word()) * limit) >> 16); }
  bool one_in(uint16_t many) { return below(many) == 0; }

  template <typename T, uint16_t N>
  T any_of(const T (&items)[N]) {
    return items[below(N)];
  }

 private:
  uint32_t state_;
};

}  // namespace vectors
