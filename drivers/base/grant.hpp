// A permission that one flipped bit of memory can take away, but not give (H-27): of the 256 values of its byte only
// one means "given", and it differs from "withheld" in all eight bits.
#pragma once

#include <stdint.h>

namespace base {

class Grant {
 public:
  constexpr explicit Grant(bool is_given = false) : code_(is_given ? given : withheld) {}

  void give() { code_ = given; }
  void withhold() { code_ = withheld; }

  constexpr bool is_given() const { return code_ == given; }
  // False once a bit has flipped: then it counts as withheld.
  constexpr bool is_intact() const { return code_ == given || code_ == withheld; }

 private:
  static constexpr uint8_t given = 0xA5;
  static constexpr uint8_t withheld = 0x5A;

  uint8_t code_;
};

}  // namespace base
