// Whether the chip still is what it was made to be: its flash, its RAM, its stack (H-22, H-27).
//
// Flash and RAM are tested before the program begins, and it does not begin if they fail; after that some bytes of
// flash and the guard below the stack are looked at again and again.
#pragma once

#include <stdint.h>

namespace drivers {
namespace self_test {

enum class Result : uint8_t {
  passed = 0,
  flash = 1,        // at the start: no program begins
  ram = 2,          // likewise
  flash_later = 3,  // it was still right at the start
};

// Of the flash, from 0 on: the image, and what is erased behind it, so that a start takes always the same time.
#ifdef PILOTFISH_OVERFLOW_TRAPS  // the tests' image is a larger one
constexpr uint16_t checked_bytes = 0xC000;
constexpr uint8_t start_takes = 255;
#else
constexpr uint16_t checked_bytes = 0x9500;
constexpr uint8_t start_takes = 226;  // from reset to the first turn of the loop, in milliseconds
#endif
constexpr uint8_t bytes_of_a_step = 4;
static_assert(checked_bytes % bytes_of_a_step == 0, "a round ends with a step");

// Once after reset: begins the first round of steps.
void start();
// Of the start; `flash_later` as soon as a round of steps has found it. Never `passed` again after anything else.
Result result();
// The next bytes of flash: call it every 10 ms, so that a round takes 95 s.
void step();
// False if the stack has been down at the variables: the bytes between are not as they were written (H-22).
bool is_stack_intact();

}  // namespace self_test
}  // namespace drivers
