// Do motors and brake coils do what they are told? Compares their currents with the outputs of the moment (H-10, H-13).
//
// Goals: an output that is stuck, and a coil that is missing or shorted, are noticed; before the first drive nothing
// moves until the bridges have shown that they block, and with every drive there is no torque until both coils were
// seen on. Assumptions: no reading is seen twice; the outputs are those of the pins; both coils are switched together
// (H-12). Invariants: what was found stays found until the supply goes (SB-2.16).
//
// Both coils share one sensor and are switched together, so which of them is wrong cannot be told.
//
// Not noticed: a motor without current. A chair that rolls downhill as fast as it is told has none either.
#pragma once

#include <stdint.h>

#include "drivers/base/grant.hpp"
#include "spm/fault_rules.hpp"
#include "spm/inputs.hpp"
#include "spm/outputs.hpp"

namespace spm {

class OutputWatch {
 public:
  // Each `limits::house_keeping`.
  void step(const Inputs& in, const Outputs& said);

  FaultSet faults() const { return faults_; }
  // Since the start: the motors had supply, no bridge was on, and there was no current.
  bool are_bridges_proven() const { return bridges_.is_given(); }
  // Since the brakes were let go.
  bool are_coils_on() const { return coils_.is_given(); }
  // An output does what it wants: bridge and relay must go at once, not by a ramp.
  bool must_cut() const { return must_cut_.is_given(); }
  bool is_intact() const { return must_cut_.is_intact() && bridges_.is_intact() && coils_.is_intact(); }  // H-27

 private:
  void watch_motor(uint8_t& run, base::Milliamps current, base::Milliamps most, Fault fault);
  void prove_bridges(const Outputs& said);
  void watch_coils(const Inputs& in, bool are_on);

  FaultSet faults_;
  base::Grant must_cut_;  // no flipped bit stops a chair at once
  uint8_t left_run_ = 0;  // looks in a row with too much current
  uint8_t right_run_ = 0;
  base::Grant bridges_;
  base::Grant coils_;
  uint8_t proof_run_ = 0;   // looks in a row at bridges that block
  uint8_t coils_seen_ = 0;  // looks in a row at coils that are on
  uint8_t coils_run_ = 0;   // looks in a row that disagree with the command
};

}  // namespace spm
