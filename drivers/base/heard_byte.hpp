// One character as a UART receiver hands it over.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace base {

struct HeardByte {
  uint8_t value;
  bool is_spoiled;  // framing error, or a character before it was lost (overrun)
  Stamp at;         // when the receiver delivered it: at its first stop bit
};

}  // namespace base
