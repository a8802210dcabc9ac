#include "drivers/store.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace store {

namespace {

using namespace base;  // literals

// 3.4 ms, as seen by somebody who asks once a millisecond.
constexpr Millis write_time = 4_ms;

}  // namespace

// A byte is there at once; only the next one has to wait as on the chip.
bool is_busy() {
  host::Machine& machine = host::selected();
  machine.is_store_writing = machine.is_store_writing && machine.now - machine.store_written_at < write_time;
  return machine.is_store_writing;
}

uint8_t read(uint16_t address) {
  return host::selected().eeprom[address % size];
}

void write(uint16_t address, uint8_t value) {
  host::Machine& machine = host::selected();
  std::uint8_t& cell = machine.eeprom[address % size];
  if (cell != value) {
    cell = value;
    machine.is_store_writing = true;
    machine.store_written_at = machine.now;
  }
}

}  // namespace store
}  // namespace drivers
