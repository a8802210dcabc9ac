// Constant tables in program memory. On the AVR a plain `const` table is copied into RAM at start;
// one marked IN_FLASH stays in flash and must be read through from_flash(). On the host both are
// ordinary memory.
#pragma once

#include <stdint.h>

#if defined(__AVR__)
// The GCC attribute behind avr-libc's PROGMEM; spelled out so that only drivers/avr includes <avr/...>.
#define IN_FLASH __attribute__((__progmem__))
#else
#define IN_FLASH
#endif

namespace base {

// The byte at `address`, which moves on to the next.
inline uint8_t next_flash_byte(const uint8_t*& address) {
#if defined(__AVR__)
  uint8_t value;
  __asm__ __volatile__("lpm %0, Z+" : "=r"(value), "+z"(address));
  return value;
#else
  return *address++;
#endif
}

inline uint8_t flash_byte(const uint8_t* address) {
  return next_flash_byte(address);
}

// A copy of one object that lives in flash.
template <typename T>
T from_flash(const T& row) {
  T copy;
  uint8_t* to = reinterpret_cast<uint8_t*>(&copy);
  const uint8_t* from = reinterpret_cast<const uint8_t*>(&row);
  for (uint8_t i = 0; i < sizeof(T); ++i) {
    to[i] = next_flash_byte(from);
  }
  return copy;
}

}  // namespace base
