#include "simulation/board/avr_flags.hpp"

namespace simulation {

AvrFlags::AvrFlags(AvrCore& core) : core_(core) {
  avr_t& avr = core.avr();
  each_module<avr_timer_t>(avr, "timer", [this](avr_timer_t& timer) {
    adopt(timer.overflow);
    adopt(timer.icr);
    for (auto& compare : timer.comp) {
      adopt(compare.interrupt);
    }
  });
  each_module<avr_extint_t>(avr, "extint", [this](avr_extint_t& pins) {
    for (auto& pin : pins.eint) {
      adopt(pin.vector);
    }
  });
  each_module<avr_ioport_t>(avr, "port", [this](avr_ioport_t& port) { adopt(port.pcint); });
}

void AvrFlags::adopt(avr_int_vector_t& vector) {
  if (vector.vector == 0) {
    return;
  }
  vectors_.push_back(&vector);
  const avr_io_addr_t mask = vector.enable.reg;
  if (masks_.count(mask) == 0) {
    masks_[mask] = replace_write<&AvrFlags::write_mask>(core_.avr(), mask, *this);
  }
  replace_write<&AvrFlags::write_flags>(core_.avr(), vector.raised.reg, *this);
}

void AvrFlags::write_mask(avr_io_addr_t address, std::uint8_t value) {
  avr_t& avr = core_.avr();
  masks_[address](avr, address, value);
  for (avr_int_vector_t* vector : vectors_) {
    if (vector->enable.reg == address && core_.interrupts().is_enabled(*vector) &&
        avr_regbit_get(&avr, vector->raised) != 0 && vector->pending == 0) {
      core_.interrupts().raise(*vector);
    }
  }
}

void AvrFlags::write_flags(avr_io_addr_t address, std::uint8_t value) {
  avr_t& avr = core_.avr();
  const std::uint8_t cleared = bits_meant(avr, value);
  avr.data[address] = static_cast<std::uint8_t>(avr.data[address] & ~cleared);
  for (avr_int_vector_t* vector : vectors_) {
    if (vector->raised.reg == address && (cleared >> vector->raised.bit & 1U) != 0) {
      core_.interrupts().withdraw(*vector);
    }
  }
}

}  // namespace simulation
