#include "spm/output_watch.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::Milliamps;

void OutputWatch::step(const Inputs& in, const Outputs& said) {
  if (!in.analog_ready) {
    return;
  }
  // A wheel that rolls has current even at zero duty, which shorts its motor: only with the bridge off there is none.
  const Milliamps most = said.bridge_enabled ? limits::most_motor_current : limits::stray_motor_current;
  watch_motor(left_run_, in.left_current, most, Fault::left_motor);
  watch_motor(right_run_, in.right_current, most, Fault::right_motor);
  watch_coils(in.brake_coils, said.left_brake == Brake::released);
}

void OutputWatch::watch_motor(uint8_t& run, Milliamps current, Milliamps most, Fault fault) {
  if (current <= most && current >= -most) {
    run = 0;
  } else if (++run >= limits::motor_looks) {  // H-10
    run = limits::motor_looks;
    faults_.put(fault, true);
    must_cut_.give();
  }
}

void OutputWatch::watch_coils(Milliamps current, bool are_on) {
  const Milliamps least = are_on ? limits::least_of_two_coils : Milliamps(0);
  const Milliamps most = are_on ? limits::most_of_two_coils : limits::half_a_coil;
  if (current >= least && current <= most) {
    coils_run_ = 0;
  } else if (++coils_run_ >= limits::coil_looks) {  // H-13
    coils_run_ = limits::coil_looks;
    faults_.put(Fault::brake, true);
  }
}

}  // namespace spm
