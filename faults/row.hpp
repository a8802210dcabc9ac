// One fault as a row of a table: what has to be true for how long, what it does to the chair, what ends it,
// and how it is shown. A row is data; manager.hpp is the only code that reads it.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"

namespace faults {

// Whether and how long the fault stops the chair.
enum class Stops : uint8_t {
  no,
  while_present,  // and no longer: drive again after neutral
  until_link,     // TRANSIENT: until communication is re-established (SB-2.16)
  until_power_down,
};

// Whether and how long the fault makes the chair limp.
enum class Limps : uint8_t {
  no,
  while_present,
  until_power_down,  // SB-2.16
};

struct Row {
  uint8_t fault;         // its number, equal to the row's place; checked where the table stands
  uint16_t debounce_ms;  // the condition must hold this long before it counts
  Stops stops;
  Limps limps;
  uint8_t system_state;  // what the bus shows, 0 = nothing; earlier rows win (SB-01.9)
  uint8_t event;         // what the log records when it begins
};

}  // namespace faults
