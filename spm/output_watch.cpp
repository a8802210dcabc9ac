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
  if (!bridges_.is_given()) {
    prove_bridges(said);
  }
  watch_coils(in, said.left_brake == Brake::released);
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

void OutputWatch::watch_coils(const Inputs& in, bool are_on) {
  const Milliamps current = in.brake_coils;
  const base::Millivolts battery = in.battery > limits::least_coil_voltage ? in.battery : limits::least_coil_voltage;
  const Milliamps least = are_on ? Milliamps(battery.count() >> limits::two_coils_shift) : Milliamps(0);
  const Milliamps most = are_on ? limits::most_of_two_coils : limits::half_a_coil;
  if (!are_on) {
    coils_.withhold();
    coils_seen_ = 0;
  }
  if (current >= least && current <= most) {
    coils_run_ = 0;
    if (are_on && ++coils_seen_ >= limits::coil_proof) {
      coils_seen_ = limits::coil_proof;
      coils_.give();
    }
    return;
  }
  coils_seen_ = 0;
  const uint8_t looks = are_coils_on() ? limits::lost_coil_looks : limits::coil_looks;
  if (++coils_run_ >= looks) {  // H-13
    coils_run_ = looks;
    faults_.put(Fault::brake, true);
    if (are_coils_on()) {  // its brake is in: what drives on only drives against it, or around it
      must_cut_.give();
    }
  }
}

// The run of looks with current, above, starts over with the one without: so does this with any.
void OutputWatch::prove_bridges(const Outputs& said) {
  const bool blocks = said.relay_closed && !said.bridge_enabled && left_run_ == 0 && right_run_ == 0;
  proof_run_ = blocks ? static_cast<uint8_t>(proof_run_ + 1) : uint8_t{0};
  if (proof_run_ >= limits::bridge_proof) {  // H-10
    bridges_.give();
  }
}

}  // namespace spm
