#include "simulation/board/avr_eeprom.hpp"

#include <algorithm>

namespace simulation {
namespace {

// EECR
constexpr std::uint8_t mode_bits = 0x30;
constexpr std::uint8_t ready_interrupt = 0x08;
constexpr std::uint8_t master_enable = 0x04;
constexpr std::uint8_t program_enable = 0x02;
constexpr std::uint8_t read_enable = 0x01;

constexpr std::uint32_t half_of_both_us = 1700;
constexpr std::uint32_t one_alone_us = 1800;
constexpr Cycle halted_by_read = 4;
constexpr Cycle halted_by_write = 2;
constexpr Cycle enable_window = 4;

}  // namespace

AvrEeprom::AvrEeprom(AvrCore& core)
    : core_(core),
      avr_(core.avr()),
      eeprom_(find_module<avr_eeprom_t>(avr_, "eeprom", [](const auto&) { return true; })) {
  replace_write<&AvrEeprom::write_control>(avr_, eeprom_.r_eecr, *this);
  core.interrupts().make_level(eeprom_.ready, [this] { return phase_ == Phase::idle; });
  core.on_reset([this] { reset(); });
}

std::vector<std::uint8_t> AvrEeprom::contents() const {
  return {eeprom_.eeprom, eeprom_.eeprom + eeprom_.size};
}

void AvrEeprom::set_contents(const std::vector<std::uint8_t>& contents) {
  const std::size_t size = std::min<std::size_t>(contents.size(), eeprom_.size);
  std::fill(eeprom_.eeprom, eeprom_.eeprom + eeprom_.size, std::uint8_t{0xFF});
  std::copy_n(contents.begin(), size, eeprom_.eeprom);
}

void AvrEeprom::lose_power() {
  phase_ = Phase::idle;
}

void AvrEeprom::lose_power(std::uint8_t left) {
  if (phase_ != Phase::idle) {
    eeprom_.eeprom[address_] = left;
  }
  lose_power();
}

std::optional<EepromWrite> AvrEeprom::write_under_way() const {
  if (phase_ == Phase::idle) {
    return std::nullopt;
  }
  const std::uint8_t kept = mode_ == Mode::write_only ? before_ : std::uint8_t{0xFF};
  const std::uint8_t after = mode_ == Mode::erase_only ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(kept & data_);
  return EepromWrite{address_, before_, after};
}

void AvrEeprom::reset() {
  if (phase_ != Phase::idle) {
    // A reset does not disturb a write that has begun.
    control() |= program_enable;
    call_after<&AvrEeprom::finish_phase>(avr_, std::max(phase_end_, avr_.cycle) - avr_.cycle, *this);
  }
}

void AvrEeprom::write_control(avr_io_addr_t, std::uint8_t value) {
  const std::uint8_t before = control();
  const bool is_idle = phase_ == Phase::idle;
  const std::uint8_t kept = before & (is_idle ? master_enable : master_enable | mode_bits | program_enable);
  const std::uint8_t taken = value & (is_idle ? ready_interrupt | mode_bits : ready_interrupt);
  control() = static_cast<std::uint8_t>(kept | taken);

  if ((value & program_enable) != 0 && is_idle) {
    if ((before & master_enable) != 0) {
      begin_write();
    } else {
      core_.complain("an EEPROM write was refused: EEMPE was not set just before");
    }
  } else if ((value & master_enable) != 0) {
    control() |= master_enable;
    call_after<&AvrEeprom::close_window>(avr_, enable_window, *this);
  }
  if ((value & read_enable) != 0) {
    read();
  }
  core_.interrupts().update(eeprom_.ready);
}

void AvrEeprom::begin_write() {
  mode_ = static_cast<Mode>((control() & mode_bits) >> 4 & 3U);
  phase_ = mode_ == Mode::write_only ? Phase::writing : Phase::erasing;
  address_ = address();
  data_ = avr_.data[eeprom_.r_eedr];
  before_ = eeprom_.eeprom[address_];
  control() = static_cast<std::uint8_t>((control() & ~master_enable) | program_enable);
  const Cycle span = cycles(mode_ == Mode::erase_and_write ? half_of_both_us : one_alone_us);
  phase_end_ = avr_.cycle + span;
  call_after<&AvrEeprom::finish_phase>(avr_, span, *this);
  avr_.cycle += halted_by_write;
}

avr_cycle_count_t AvrEeprom::finish_phase(avr_cycle_count_t when) {
  std::uint8_t& cell = eeprom_.eeprom[address_];
  if (phase_ == Phase::erasing) {
    cell = 0xFF;
    if (mode_ == Mode::erase_and_write) {
      phase_ = Phase::writing;
      phase_end_ = when + cycles(half_of_both_us);
      return phase_end_;
    }
  } else {
    cell &= data_;
  }
  phase_ = Phase::idle;
  control() = static_cast<std::uint8_t>(control() & ~program_enable);
  core_.interrupts().update(eeprom_.ready);
  return 0;
}

avr_cycle_count_t AvrEeprom::close_window(avr_cycle_count_t) {
  control() = static_cast<std::uint8_t>(control() & ~master_enable);
  return 0;
}

void AvrEeprom::read() {
  if (phase_ != Phase::idle) {
    core_.complain("the EEPROM was read during a write");
    return;
  }
  avr_.data[eeprom_.r_eedr] = eeprom_.eeprom[address()];
  avr_.cycle += halted_by_read;
}

Cycle AvrEeprom::cycles(std::uint32_t microseconds) const {
  return Cycle{avr_.frequency} * microseconds / 1'000'000;
}

std::uint16_t AvrEeprom::address() const {
  const unsigned address = avr_.data[eeprom_.r_eearl] | static_cast<unsigned>(avr_.data[eeprom_.r_eearh]) << 8;
  return static_cast<std::uint16_t>(address % eeprom_.size);
}

}  // namespace simulation
