#include "drivers/signals.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace signals {

void start() {
  host::selected().switched = Switched();
}

void apply(const Switched& outputs) {
  Switched& pins = host::selected().switched;
  pins = outputs;
  pins.actuator1_extend = outputs.actuator1_extend && !outputs.actuator1_retract;
  pins.actuator1_retract = outputs.actuator1_retract && !outputs.actuator1_extend;
  pins.actuator2_extend = outputs.actuator2_extend && !outputs.actuator2_retract;
  pins.actuator2_retract = outputs.actuator2_retract && !outputs.actuator2_extend;
}

void refresh() {}

Sensed sense() {
  return host::selected().sensed;
}

bool is_awake() {
  return host::selected().wake;
}

}  // namespace signals
}  // namespace drivers
