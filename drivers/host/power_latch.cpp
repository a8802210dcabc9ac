#include "drivers/power_latch.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace power_latch {

void hold() {
  host::selected().latch_held = true;
}

void refresh() {}

void release() {
  host::selected().latch_held = false;
}

}  // namespace power_latch
}  // namespace drivers
