#include "drivers/analog.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace analog {

void start() {}

void scan() {}

uint16_t raw(Channel channel) {
  return host::selected().analog_raw[static_cast<uint8_t>(channel)];
}

// The simulation measures all channels before the firmware first asks.
bool is_ready() {
  return true;
}

}  // namespace analog
}  // namespace drivers
