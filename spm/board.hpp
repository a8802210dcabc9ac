// The only place where the power module meets its drivers: readings become Inputs, Outputs become pins.
#pragma once

#include "drivers/base/time.hpp"
#include "spm/inputs.hpp"
#include "spm/outputs.hpp"
#include "spm/settings.hpp"

namespace spm {

class Board {
 public:
  // All drivers, once after reset, interrupts off. Every output is safe afterwards.
  void start();
  // As stored; that they could not be read shows in every later sense().
  Settings settings();

  // What the bus says is always new; voltages, currents and switches are read once a millisecond.
  const Inputs& sense(base::Instant now);
  void apply(const Outputs& outputs);

 private:
  void sense_bus();
  void sense_slow();

  Inputs in_;
  base::Instant last_slow_;
  bool has_sensed_ = false;
};

}  // namespace spm
