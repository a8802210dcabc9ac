// Two 12 V lead batteries in series, with their leads.
#pragma once

#include <optional>

namespace simulation {

class Battery {
 public:
  static constexpr double resistance = 0.05;  // ohm

  double open_circuit() const;                // V
  double charge() const { return charge_; }   // 1 = full
  void discharge(double amperes, double dt);  // seconds; negative amperes charge
  void force_open_circuit(double volts) { forced_ = volts; }

 private:
  double charge_ = 1;
  std::optional<double> forced_;
};

}  // namespace simulation
