#include "spm/battery.hpp"

#include "spm/current_steps.hpp"
#include "spm/limits.hpp"

namespace spm {

using base::Millivolts;

namespace {

constexpr uint8_t looks_between = 10;

// What goes through a bridge to its motor, as the battery sees it: duty times current.
int32_t share_of(Demand duty, base::Milliamps current) {
  return static_cast<int32_t>(duty.count()) * current_steps(current);
}

// Millivolts that the load takes, negative while the motors feed the battery. The sensors of motors and coils tell what
// it gives; the electronics are a constant.
int16_t sag_of(const Inputs& in, const Outputs& said, uint16_t milliohms) {
  const int32_t motors = share_of(said.left, in.left_current) + share_of(said.right, in.right_current);
  // A shift is what the AVR does quickly; that it rounds downwards is a step of 64 mA at most.
  const int16_t load = static_cast<int16_t>(static_cast<int16_t>((motors * 4) >> 16) + current_steps(in.brake_coils) +
                                            current_steps(limits::electronics_current));
  static_assert(full_demand.count() * int32_t{4} == int32_t{1} << 16, "a duty of 1");
  // Steps times milliohms are 64 microvolts each: 131 / 2048 of a millivolt.
  const int32_t sag = (static_cast<int32_t>(load) * static_cast<int16_t>(milliohms) * 131) >> 11;
  constexpr int16_t most = limits::most_sag.count();
  return static_cast<int16_t>(sag > most ? most : sag < -most ? -most : sag);
}

}  // namespace

// Not inlined: what is done seldom must not cost the loop's big functions registers.
__attribute__((noinline)) bool Battery::step(const Inputs& in, const Outputs& said, const Settings& settings,
                                             FaultSet known) {
  if (!in.analog_ready) {
    return false;
  }
  if (until_next_ != 0) {
    --until_next_;
    return false;
  }
  until_next_ = looks_between - 1;
  const int32_t rest =
      static_cast<int32_t>(in.battery.count()) + sag_of(in, said, settings[Setting::battery_resistance]);
  at_rest_ = Millivolts(static_cast<uint16_t>(rest < 0 ? 0 : rest));

  const Millivolts back = limits::battery_hysteresis;
  const Millivolts low(settings[Setting::battery_low]);
  const Millivolts high(settings[Setting::battery_high]);
  const bool is_low = known.has(Fault::battery_low);
  faults_.put(Fault::battery_flat, at_rest_ < Millivolts(settings[Setting::battery_cutoff]));
  faults_.put(Fault::battery_low, at_rest_ < (is_low ? low + back : low));
  faults_.put(Fault::over_voltage, in.battery > (known.has(Fault::over_voltage) ? high - back : high));
  slow_down(is_low, said.left_brake == Brake::engaged);
  return true;
}

void Battery::slow_down(bool is_low, bool is_at_rest) {
  if (is_low) {
    const Demand next = ceiling_ - limits::low_battery_step;
    ceiling_ = next > limits::low_battery_ceiling ? next : limits::low_battery_ceiling;
  } else if (is_at_rest) {  // H-33: slow-down, then recovery, is acceleration that nobody asked for
    ceiling_ = full_demand;
  }
  if (ceiling_ < limits::low_battery_ceiling || ceiling_ > full_demand) {  // H-27
    ceiling_ = limits::low_battery_ceiling;
  }
}

}  // namespace spm
