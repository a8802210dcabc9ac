#include "drivers/signals.hpp"

#include <avr/io.h>

#include "drivers/avr/board_spm.hpp"

namespace drivers {
namespace signals {

namespace {

// What the two ports shall show, the pull-ups included. No interrupt touches these ports.
uint8_t levels_b = avr::pulled_up_b;
uint8_t levels_c = avr::pulled_up_c;

constexpr uint8_t own_b = avr::switched_b | avr::pulled_up_b | avr::Wake::mask;
constexpr uint8_t own_c = avr::switched_c | avr::pulled_up_c;

template <typename Extend, typename Retract>
uint8_t actuator(bool extend, bool retract) {
  if (extend == retract) {
    return 0;
  }
  return extend ? Extend::mask : Retract::mask;
}

}  // namespace

void start() {
  apply(Switched());
}

void apply(const Switched& outputs) {
  levels_b = static_cast<uint8_t>(
      avr::pulled_up_b | (outputs.status_led ? avr::StatusLed::mask : 0) |
      actuator<avr::Actuator1Extend, avr::Actuator1Retract>(outputs.actuator1_extend, outputs.actuator1_retract) |
      actuator<avr::Actuator2Extend, avr::Actuator2Retract>(outputs.actuator2_extend, outputs.actuator2_retract));
  levels_c = static_cast<uint8_t>(avr::pulled_up_c | (outputs.left_indicator ? avr::LeftIndicator::mask : 0) |
                                  (outputs.right_indicator ? avr::RightIndicator::mask : 0) |
                                  (outputs.headlight ? avr::Headlight::mask : 0));
  refresh();
}

void refresh() {
  PORTB = static_cast<uint8_t>((PORTB & ~own_b) | levels_b);
  PORTC = static_cast<uint8_t>((PORTC & ~own_c) | levels_c);
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
