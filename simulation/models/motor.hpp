// A 24 V brushed motor with its gearbox, seen at the tread of its wheel: m/s and newtons. Its inductance
// (well below a millisecond) is left out.
#pragma once

namespace simulation {

struct Motor {
  static constexpr double resistance = 0.15;   // ohm
  static constexpr double constant = 8.8;      // V per m/s, and N per A
  static constexpr double gear_friction = 15;  // N, dry

  double back_emf(double speed) const;               // V
  double current(double volts, double speed) const;  // A, closed circuit
  double force(double amperes) const;                // N, before friction
};

}  // namespace simulation
