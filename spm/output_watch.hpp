// Do motors and brake coils do what they are told? Compares their currents with the outputs of the moment (H-10, H-13).
//
// Goals: an output that is stuck, and a coil that is missing or shorted, are noticed; which side it is, if that can be
// told. Assumptions: no reading is seen twice; the outputs are those of the pins.
// Invariants: what was found stays found until the supply goes (SB-2.16); at most one fault of the brakes is named.
//
// Both coils share one sensor. The left one is switched on first, so a release tells which of them is wrong. What goes
// wrong later is shown as the left one's; the next release after power-up tells.
//
// Not noticed: a motor without current. A chair that rolls downhill as fast as it is told has none either.
#pragma once

#include <stdint.h>

#include "spm/fault_rules.hpp"
#include "spm/inputs.hpp"
#include "spm/outputs.hpp"

namespace spm {

class OutputWatch {
 public:
  // Each `limits::house_keeping`.
  void step(const Inputs& in, const Outputs& said);

  FaultSet faults() const { return faults_; }
  // An output does what it wants: bridge and relay must go at once, not by a ramp.
  bool must_cut() const { return must_cut_; }

 private:
  void watch_motor(uint8_t& run, base::Milliamps current, base::Milliamps most, Fault fault);
  void watch_coils(base::Milliamps current, bool is_left_on, bool is_right_on);

  FaultSet faults_;
  bool must_cut_ = false;
  uint8_t left_run_ = 0;  // looks in a row with too much current
  uint8_t right_run_ = 0;
  uint8_t coils_run_ = 0;        // looks in a row that disagree with the command
  bool is_left_proven_ = false;  // alone it drew what it should, and both together have not yet
};

}  // namespace spm
