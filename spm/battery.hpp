// What the battery can still give, and what it can still take (H-26).
//
// Goals: the voltage is judged as it would be without load, so that a slope is not taken for an empty battery. A low
// battery slows the chair first: half the acceleration at once, then, a little at a time, half the top speed.
// Assumptions: no reading is seen twice; the outputs are those of the pins.
// Invariants: top speed comes back only while the brakes are engaged: no chair gathers speed because its battery has
// recovered (H-33).
#pragma once

#include <stdint.h>

#include "drivers/base/units.hpp"
#include "spm/fault_rules.hpp"
#include "spm/inputs.hpp"
#include "spm/outputs.hpp"
#include "spm/settings.hpp"

namespace spm {

class Battery {
 public:
  // Each `limits::house_keeping`; true with every tenth, which does the work. `known` are the faults that count
  // already: they end later than they begin.
  bool step(const Inputs& in, const Outputs& said, const Settings& settings, FaultSet known);

  FaultSet faults() const { return faults_; }
  // The voltage there would be without load; 0 before the first reading.
  base::Millivolts at_rest() const { return at_rest_; }
  // No command asks for more.
  Demand ceiling() const { return ceiling_; }

 private:
  void slow_down(bool is_low, bool is_at_rest);

  FaultSet faults_;
  base::Millivolts at_rest_;
  uint8_t until_next_ = 0;
  Demand ceiling_ = full_demand;
};

}  // namespace spm
