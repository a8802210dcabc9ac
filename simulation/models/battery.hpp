// Two 12 V lead batteries in series, with their leads.
//
// Against charging a full lead battery resists more than against discharging: its plates have nothing left to turn, so
// the voltage climbs to where water is split (2.4 to 2.65 V a cell, 28.8 to 31.8 V here, at a tenth of the capacity an
// hour and more; textbooks on lead batteries and the chargers' own 28.8 to 29.6 V say so alike). 0.25 ohm at full
// charge and 25.4 V give 28.4 V at 12 A and 31.9 V at 26 A; below nine tenths of the charge nothing is left of that.
#pragma once

#include <optional>

namespace simulation {

class Battery {
 public:
  static constexpr double resistance = 0.05;  // ohm, while it is discharged

  double open_circuit() const;                // V
  double charging_resistance() const;         // ohm
  double charge() const { return charge_; }   // 1 = full
  void discharge(double amperes, double dt);  // seconds; negative amperes charge
  void force_open_circuit(double volts) { forced_ = volts; }

 private:
  double charge_ = 1;
  std::optional<double> forced_;
};

}  // namespace simulation
