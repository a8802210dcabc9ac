#include "drivers/clock.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace clock {

void start() {}

base::Instant now() {
  return host::selected().now;
}

base::Stamp stamp() {
  return host::selected().stamp;
}

}  // namespace clock
}  // namespace drivers
