// Everything the power module says in one step, as values. Outputs{} is the safe state: no torque, brakes
// engaged, lamps off, silence; the supply stays as it is.
#pragma once

#include <stdint.h>

#include "bus/shark/responder.hpp"
#include "drivers/base/span.hpp"
#include "drivers/base/units.hpp"
#include "faults/event.hpp"

namespace spm {

// Signed share of full motor voltage, forward positive: +-full is all of it.
using Demand = base::Quantity<struct DemandTag, int16_t>;
constexpr Demand full_demand = Demand(16384);

enum class Brake : uint8_t { engaged, released };
enum class Latch : uint8_t { as_it_is, hold, release };

using bus::shark::Speech;

struct Outputs {
  // What repeats the step before need not be written to the pins again: motors, brakes, bridge and relay; all others.
  bool are_motors_as_before = false;
  bool are_switches_as_before = false;

  Demand left;
  Demand right;
  bool bridge_enabled = false;
  bool relay_closed = false;
  Brake left_brake = Brake::engaged;
  Brake right_brake = Brake::engaged;

  bool left_indicator = false;
  bool right_indicator = false;
  bool headlight = false;
  bool status_led = false;

  Latch latch = Latch::as_it_is;

  base::Span<const faults::Event> events;  // of this step, those to be kept; valid until the next step

  bool is_time_pressing = false;  // a millisecond is too coarse a grain for the next steps
  // So many characters from now on nothing needs to be done, unless time passes.
  uint8_t awaited = 0;
  Speech speech = Speech::as_it_is;
  base::Span<const uint8_t> turn;  // valid until the next step
};

}  // namespace spm
