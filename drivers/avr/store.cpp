#include "drivers/store.hpp"

#include <avr/io.h>

#include "drivers/avr/interrupt_lock.hpp"

namespace drivers {
namespace store {

static_assert(size == E2END + 1, "the store is the whole EEPROM");

bool is_busy() {
  return (EECR & _BV(EEPE)) != 0;
}

uint8_t read(uint16_t address) {
  EEAR = address;
  EECR = _BV(EERE);
  return EEDR;
}

void write(uint16_t address, uint8_t value) {
  if (read(address) == value) {
    return;
  }
  EEDR = value;
  avr::InterruptLock lock;  // the second write must follow within four cycles
  EECR = _BV(EEMPE);
  EECR |= _BV(EEPE);
}

}  // namespace store
}  // namespace drivers
