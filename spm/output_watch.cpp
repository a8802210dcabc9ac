#include "spm/output_watch.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::Milliamps;

void OutputWatch::step(const Inputs& in, const Outputs& said) {
  if (!in.analog_ready) {
    return;
  }
  const bool is_left_on = said.left_brake == Brake::released;
  const bool is_right_on = said.right_brake == Brake::released;
  // A wheel that rolls has current even at zero duty, which shorts its motor: only with the bridge off there is none.
  const Milliamps most = said.bridge_enabled ? limits::most_motor_current : limits::stray_motor_current;
  watch_motor(left_run_, in.left_current, most, Fault::left_motor);
  watch_motor(right_run_, in.right_current, most, Fault::right_motor);
  watch_coils(in.brake_coils, is_left_on, is_right_on);
}

void OutputWatch::watch_motor(uint8_t& run, Milliamps current, Milliamps most, Fault fault) {
  if (current <= most && current >= -most) {
    run = 0;
  } else if (++run >= limits::motor_looks) {  // H-10
    run = limits::motor_looks;
    faults_.put(fault, true);
    must_cut_ = true;
  }
}

void OutputWatch::watch_coils(Milliamps current, bool is_left_on, bool is_right_on) {
  const bool are_both_on = is_left_on && is_right_on;
  const bool is_one_on = is_left_on != is_right_on;
  const Milliamps least = are_both_on ? limits::least_of_two_coils : is_one_on ? limits::half_a_coil : Milliamps(0);
  const Milliamps most = are_both_on ? limits::most_of_two_coils
                         : is_one_on ? limits::most_of_a_coil
                                     : limits::half_a_coil;
  const bool agrees = current >= least && current <= most;
  if (is_one_on) {
    is_left_proven_ = agrees;
  } else if (agrees || !are_both_on) {
    is_left_proven_ = false;
  }
  if (agrees) {
    coils_run_ = 0;
  } else if (++coils_run_ >= limits::coil_looks) {  // H-13
    coils_run_ = limits::coil_looks;
    if (!faults_.has(FaultSet::of(Fault::left_brake) | FaultSet::of(Fault::right_brake))) {
      faults_.put(is_left_proven_ ? Fault::right_brake : Fault::left_brake, true);
    }
  }
}

}  // namespace spm
