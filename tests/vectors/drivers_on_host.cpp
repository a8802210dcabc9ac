#include "drivers/host/machine.hpp"
#include "tests/vectors/drivers.hpp"

namespace vectors {

namespace {

drivers::host::Machine& machine() {
  static drivers::host::Machine machine;
  return machine;
}

}  // namespace

void measure(uint16_t raw) {
  drivers::host::select(machine());
  machine().analog_raw.fill(raw);
  machine().converted.fill(raw);
  machine().converting = raw;
}

const drivers::bridge::Motion& motion() {
  return machine().motion;
}

}  // namespace vectors
