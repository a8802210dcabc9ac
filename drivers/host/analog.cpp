#include "drivers/analog.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace analog {

namespace {

// What is on the pin at this moment is what a scan later has been converted.
void convert(host::Machine& machine) {
  machine.converting = machine.analog_raw[machine.scan_order.current()];
}

}  // namespace

void start() {
  host::Machine& machine = host::selected();
  machine.scan_order = decltype(machine.scan_order)();
  machine.converted = {};
  convert(machine);
}

void scan() {
  host::Machine& machine = host::selected();
  machine.converted[machine.scan_order.current()] = machine.converting;
  machine.scan_order.advance();
  convert(machine);
}

uint16_t raw(Channel channel) {
  return host::selected().converted[static_cast<uint8_t>(channel)];
}

bool is_ready() {
  return host::selected().scan_order.is_complete();
}

}  // namespace analog
}  // namespace drivers
