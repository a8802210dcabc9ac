// How an interrupt tells the loop that there is something to do: one bit that survives until the loop has seen it.
#pragma once

#include <avr/io.h>

namespace drivers {
namespace avr {

// A bit of a register that sbi, cbi and sbis reach: one instruction each, so no lock is needed.
inline void call_loop() {
  GPIOR0 |= _BV(0);
}
inline void answer_call() {
  GPIOR0 &= static_cast<uint8_t>(~_BV(0));
}
inline bool is_loop_called() {
  return (GPIOR0 & _BV(0)) != 0;
}

}  // namespace avr
}  // namespace drivers
