#include "drivers/store.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace store {

// A write is done at once.
bool is_busy() {
  return false;
}

uint8_t read(uint16_t address) {
  return host::selected().eeprom[address % size];
}

void write(uint16_t address, uint8_t value) {
  host::selected().eeprom[address % size] = value;
}

}  // namespace store
}  // namespace drivers
