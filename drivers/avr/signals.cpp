#include "drivers/signals.hpp"

#include "drivers/avr/board_spm.hpp"

namespace drivers {
namespace signals {

namespace {

template <typename Extend, typename Retract>
void move_actuator(bool extend, bool retract) {
  const bool is_both = extend && retract;
  Extend::write(extend && !is_both);
  Retract::write(retract && !is_both);
  Extend::make_output();
  Retract::make_output();
}

template <typename Output>
void write(bool is_on) {
  Output::write(is_on);
  Output::make_output();
}

}  // namespace

void start() {
  avr::Wake::make_input();
  avr::DciSlowdown::make_input();
  avr::DciSlowdown::set();  // pull-up
  avr::LightingStrap::make_input();
  avr::LightingStrap::set();
  apply(Switched());
}

void apply(const Switched& outputs) {
  write<avr::LeftIndicator>(outputs.left_indicator);
  write<avr::RightIndicator>(outputs.right_indicator);
  write<avr::Headlight>(outputs.headlight);
  write<avr::StatusLed>(outputs.status_led);
  move_actuator<avr::Actuator1Extend, avr::Actuator1Retract>(outputs.actuator1_extend, outputs.actuator1_retract);
  move_actuator<avr::Actuator2Extend, avr::Actuator2Retract>(outputs.actuator2_extend, outputs.actuator2_retract);
}

Sensed sense() {
  Sensed sensed;
  sensed.dci_slowdown = !avr::DciSlowdown::is_high();
  sensed.lighting_fitted = !avr::LightingStrap::is_high();
  return sensed;
}

bool is_awake() {
  return avr::Wake::is_high();
}

}  // namespace signals
}  // namespace drivers
