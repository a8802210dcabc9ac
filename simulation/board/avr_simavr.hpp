// The only door to simavr: its headers, and typed hooks in place of its C callbacks. For avr_*.cpp only.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>

extern "C" {
#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>
#include <simavr/avr_uart.h>
#include <simavr/avr_watchdog.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
}

namespace simulation {

// Registers that simavr has no name for; the same in all megaAVRs since the ATmega48.
constexpr avr_io_addr_t sleep_mode_register = 0x53;  // SMCR
constexpr avr_io_addr_t first_ram_address = 0x100;

// Calls `visit` with every peripheral of a kind ("uart", "timer", ...).
template <typename Module, typename Visit>
void each_module(avr_t& avr, const char* kind, Visit visit) {
  for (avr_io_t* io = avr.io_port; io != nullptr; io = io->next) {
    if (std::strcmp(io->kind, kind) == 0) {
      visit(*reinterpret_cast<Module*>(io));
    }
  }
}

// The peripheral of that kind for which `is_wanted` holds.
template <typename Module, typename Wanted>
Module& find_module(avr_t& avr, const char* kind, Wanted is_wanted) {
  Module* found = nullptr;
  each_module<Module>(avr, kind, [&](Module& module) { found = is_wanted(module) ? &module : found; });
  if (found == nullptr) {
    throw std::runtime_error(std::string("the simulated chip lacks a ") + kind);
  }
  return *found;
}

// What ran before when the program wrote a register; call it to keep simavr's own behaviour.
struct WriteHook {
  avr_io_write_t call = nullptr;
  void* param = nullptr;

  void operator()(avr_t& avr, avr_io_addr_t address, std::uint8_t value) const {
    if (call != nullptr) {
      call(&avr, address, value, param);
    } else {
      avr.data[address] = value;
    }
  }
};

// `Method(address, value)` runs instead of whatever simavr does when the program writes `address`.
template <auto Method, typename Part>
WriteHook replace_write(avr_t& avr, avr_io_addr_t address, Part& part) {
  auto& slot = avr.io[AVR_DATA_TO_IO(address)].w;
  const WriteHook before{slot.c, slot.param};
  slot.param = &part;
  slot.c = [](avr_t*, avr_io_addr_t at, std::uint8_t value, void* param) {
    (static_cast<Part*>(param)->*Method)(at, value);
  };
  return before;
}

// `Method()` supplies the value when the program reads `address`.
template <auto Method, typename Part>
void replace_read(avr_t& avr, avr_io_addr_t address, Part& part) {
  auto& slot = avr.io[AVR_DATA_TO_IO(address)].r;
  slot.param = &part;
  slot.c = [](avr_t*, avr_io_addr_t, void* param) { return (static_cast<Part*>(param)->*Method)(); };
}

// `Method(value)` runs whenever the signal is raised.
template <auto Method, typename Part>
void on_signal(avr_irq_t* signal, Part& part) {
  avr_irq_register_notify(
      signal, [](avr_irq_t*, std::uint32_t value, void* param) { (static_cast<Part*>(param)->*Method)(value); }, &part);
}

template <auto Method, typename Part>
avr_cycle_count_t timer_callback(avr_t*, avr_cycle_count_t when, void* part) {
  return (static_cast<Part*>(part)->*Method)(when);
}

// `Method(when)` runs `cycles` from now, once more at the cycle it returns, or never if that is 0.
// A reset of the chip drops it. Set again, it moves.
template <auto Method, typename Part>
void call_after(avr_t& avr, avr_cycle_count_t cycles, Part& part) {
  avr_cycle_timer_register(&avr, cycles, timer_callback<Method, Part>, &part);
}

template <auto Method, typename Part>
void cancel_call(avr_t& avr, Part& part) {
  avr_cycle_timer_cancel(&avr, timer_callback<Method, Part>, &part);
}

// The bits that the instruction now writing means to write: SBI touches one bit on silicon, while simavr
// turns it into a read and a write of the whole register.
inline std::uint8_t bits_meant(const avr_t& avr, std::uint8_t written) {
  const unsigned opcode = avr.flash[avr.pc] | static_cast<unsigned>(avr.flash[avr.pc + 1]) << 8;
  const bool is_sbi = (opcode & 0xFF00U) == 0x9A00U;
  return is_sbi ? static_cast<std::uint8_t>(1U << (opcode & 7U)) : written;
}

}  // namespace simulation
