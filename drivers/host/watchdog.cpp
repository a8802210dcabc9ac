#include "drivers/watchdog.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace watchdog {

void start() {}

void feed() {
  ++host::selected().watchdog_feeds;
}

ResetCause reset_cause() {
  return host::selected().reset_cause;
}

}  // namespace watchdog
}  // namespace drivers
