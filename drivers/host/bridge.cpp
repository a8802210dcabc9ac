#include "drivers/bridge.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace bridge {

namespace {

uint16_t duty_or_none(uint16_t duty) {
  return duty <= full_duty ? duty : uint16_t{0};
}

}  // namespace

void start() {
  host::selected().motion = Motion();
}

void apply(const Motion& motion) {
  Motion& pins = host::selected().motion;
  pins = motion;
  pins.left.duty = duty_or_none(motion.left.duty);
  pins.right.duty = duty_or_none(motion.right.duty);
}

}  // namespace bridge
}  // namespace drivers
