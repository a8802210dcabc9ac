#include "drivers/clock.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace clock {

void start() {}

void refresh() {}

void refresh_stamps() {}

base::Instant now() {
  return host::selected().now;
}

base::Stamp stamp() {
  return host::selected().stamp;
}

void tick_twice(bool is_wanted) {
  host::selected().is_ticking_twice = is_wanted;
}

}  // namespace clock
}  // namespace drivers
