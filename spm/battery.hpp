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
  // Each `limits::house_keeping`. `known` are the faults that count already: they end later than they begin.
  void step(const Inputs& in, const Outputs& said, const Settings& settings, FaultSet known);

  FaultSet faults() const { return faults_; }
  // The voltage there would be without load; 0 before the first reading.
  base::Millivolts at_rest() const { return at_rest_; }
  // No command asks for more.
  Demand ceiling() const { return ceiling_; }
  bool is_low() const { return ceiling_ < full_demand; }

 private:
  void weigh_load(const Inputs& in, const Outputs& said, const Settings& settings);
  void slow_down(bool is_low, bool is_at_rest);

  FaultSet faults_;
  base::Millivolts at_rest_;
  int16_t sag_ = 0;  // millivolts that the load takes, negative while the motors feed the battery
  uint8_t until_weighed_ = 0;
  Demand ceiling_ = full_demand;
};

}  // namespace spm
