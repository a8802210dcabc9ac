#include "spm/battery.hpp"

#include "spm/current_steps.hpp"
#include "spm/limits.hpp"

namespace spm {

using base::Millivolts;

namespace {

constexpr uint8_t looks_between = 10;  // the load is weighed that often only: the product costs

// What goes through a bridge to its motor, as the battery sees it: duty times current.
int32_t share_of(Demand duty, base::Milliamps current) {
  return static_cast<int32_t>(duty.count()) * current_steps(current);
}

}  // namespace

void Battery::step(const Inputs& in, const Outputs& said, const Settings& settings, FaultSet known) {
  if (!in.analog_ready) {
    return;
  }
  if (until_weighed_ == 0) {
    until_weighed_ = looks_between;
    weigh_load(in, said, settings);
    slow_down(known.has(Fault::battery_low), said.left_brake == Brake::engaged);
  }
  --until_weighed_;
  const int32_t rest = static_cast<int32_t>(in.battery.count()) + sag_;
  at_rest_ = Millivolts(static_cast<uint16_t>(rest < 0 ? 0 : rest));

  const Millivolts back = limits::battery_hysteresis;
  const Millivolts low(settings[Setting::battery_low]);
  const Millivolts over(settings[Setting::battery_high]);
  faults_.put(Fault::battery_flat, at_rest_ < Millivolts(settings[Setting::battery_cutoff]));
  faults_.put(Fault::battery_low, at_rest_ < (known.has(Fault::battery_low) ? low + back : low));
  faults_.put(Fault::over_voltage, in.battery > (known.has(Fault::over_voltage) ? over - back : over));
}

// The sensors of motors and coils tell what the battery gives; the electronics are a constant.
void Battery::weigh_load(const Inputs& in, const Outputs& said, const Settings& settings) {
  const int32_t motors =
      (share_of(said.left, in.left_current) + share_of(said.right, in.right_current)) / full_demand.count();
  const int16_t load =
      static_cast<int16_t>(motors + current_steps(in.brake_coils) + current_steps(limits::electronics_current));
  // Steps times milliohms are 64 microvolts each: 131 / 2048 of a millivolt.
  const int32_t product = static_cast<int32_t>(load) * static_cast<int16_t>(settings[Setting::battery_resistance]);
  const int32_t sag = product * 131 / 2048;
  constexpr int16_t most = limits::most_sag.count();
  sag_ = static_cast<int16_t>(sag > most ? most : sag < -most ? -most : sag);
}

void Battery::slow_down(bool is_low, bool is_at_rest) {
  if (is_low) {
    const Demand next = ceiling_ - limits::low_battery_step;
    ceiling_ = next > limits::low_battery_ceiling ? next : limits::low_battery_ceiling;
  } else if (is_at_rest) {  // H-33: slow-down, then recovery, is acceleration that nobody asked for
    ceiling_ = full_demand;
  }
}

}  // namespace spm
