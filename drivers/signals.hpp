// The switched outputs that do not move the chair, and the digital inputs.
#pragma once

#include <stdint.h>

namespace drivers {
namespace signals {

struct Switched {
  bool left_indicator = false;
  bool right_indicator = false;
  bool headlight = false;
  bool actuator1_extend = false;
  bool actuator1_retract = false;
  bool actuator2_extend = false;
  bool actuator2_retract = false;
  bool status_led = false;
};

struct Sensed {
  bool dci_slowdown = false;     // seat or lift asks for slow
  bool lighting_fitted = false;  // option strap
};

void start();
// Never energises extend and retract of one actuator together, whatever is asked.
void apply(const Switched& outputs);
// Writes all of them again, and the inputs' pull-ups (H-27); upkeep.hpp calls it.
void refresh();
Sensed sense();
bool is_awake();  // SBH above 12 V

}  // namespace signals
}  // namespace drivers
