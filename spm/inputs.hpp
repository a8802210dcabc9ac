// Everything the power module is told in one step, as values.
#pragma once

#include <stdint.h>

#include "drivers/base/heard_byte.hpp"
#include "drivers/base/span.hpp"
#include "drivers/base/time.hpp"
#include "drivers/base/units.hpp"

namespace spm {

// How the last start came about.
enum class Start : uint8_t {
  power_on = 0,   // the normal case: somebody pressed the power button
  watchdog = 1,   // SB-3.9
  brown_out = 2,  // SB-3.9
  external = 3,   // the reset pin, or a programmer
};

constexpr bool is_unexpected(Start start) {
  return start == Start::watchdog || start == Start::brown_out;
}

// H-27: what the chip's self-test has found; the numbers are those of the event. After the first two no program begins.
enum class SelfTest : uint8_t { passed = 0, flash = 1, ram = 2, flash_later = 3 };

// What the bus transmitter is doing.
enum class Speaker : uint8_t { idle, armed, speaking };

struct Inputs {
  // Characters from the bus since the last step, oldest first, our own excluded.
  base::Array<base::HeardByte, 12> heard = {};
  uint8_t heard_count = 0;
  base::Stamp stamp;  // the time of this step on the scale of the heard bytes
  Speaker speaker = Speaker::idle;
  bool echo_differed = false;  // SB-1.4, since the last step
  bool wake = false;           // SBH above 12 V (SB-1.3)

  base::Millivolts battery;
  base::Milliamps left_current;  // forward positive
  base::Milliamps right_current;
  base::Milliamps brake_coils;  // both together
  bool analog_ready = false;    // the readings above are real

  bool dci_slowdown = false;
  bool lighting_fitted = false;
  Start start = Start::power_on;     // constant from reset on
  bool settings_lost = false;        // stored settings could not be read; constant from reset on
  bool settings_copy_bad = false;    // one of two copies could not; constant from reset on
  bool is_storing = false;           // something is to be written to the EEPROM, or being written
  bool has_restarted_often = false;  // H-25: three unexpected starts within 10 s; constant from reset on
  base::Millis start_took;           // from reset to the first step
  SelfTest self_test = SelfTest::passed;
  bool has_stack_overrun = false;  // H-22: it has been where it must never come; stays
};

}  // namespace spm
