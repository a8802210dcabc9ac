#include "simulation/board/avr_uart.hpp"

namespace simulation {
namespace {

// UCSRnA
constexpr std::uint8_t receive_complete = 0x80;
constexpr std::uint8_t transmit_complete = 0x40;
constexpr std::uint8_t data_empty = 0x20;
constexpr std::uint8_t frame_error = 0x10;
constexpr std::uint8_t data_overrun = 0x08;
constexpr std::uint8_t double_speed = 0x02;
constexpr std::uint8_t writable_status = 0x03;
// UCSRnB
constexpr std::uint8_t transmit_complete_interrupt = 0x40;
constexpr std::uint8_t receiver_enable = 0x10;
constexpr std::uint8_t transmitter_enable = 0x08;
constexpr std::uint8_t ninth_bit = 0x04;
constexpr std::uint8_t received_ninth_bit = 0x02;
// UCSRnC
constexpr std::uint8_t parity_mode = 0x30;
constexpr std::uint8_t two_stop_bits = 0x08;

constexpr std::size_t receiver_capacity = 3;

}  // namespace

AvrUart::AvrUart(AvrCore& core, char name)
    : core_(core),
      avr_(core.avr()),
      uart_(find_module<avr_uart_t>(avr_, "uart", [name](const auto& uart) { return uart.name == name; })) {
  replace_write<&AvrUart::write_data>(avr_, uart_.r_udr, *this);
  replace_read<&AvrUart::read_data>(avr_, uart_.r_udr, *this);
  replace_write<&AvrUart::write_status>(avr_, uart_.r_ucsra, *this);
  avr_.io[AVR_DATA_TO_IO(uart_.r_ucsra)].r = {};
  replace_write<&AvrUart::write_control>(avr_, uart_.r_ucsrb, *this);
  replace_write<&AvrUart::write_plain>(avr_, static_cast<avr_io_addr_t>(uart_.ubrrl.reg), *this);
  core.interrupts().make_level(uart_.rxc, [this] { return !heard_.empty(); });
  core.interrupts().make_level(uart_.udrc, [this] { return !is_buffer_full_; });
  core.on_reset([this] { reset(); });
}

void AvrUart::reset() {
  heard_.clear();
  has_overrun_ = is_shifting_ = is_buffer_full_ = false;
  avr_.data[uart_.r_ucsra] = data_empty;
  avr_.data[uart_.r_ucsrb] = 0;  // simavr leaves the transmitter on
}

void AvrUart::hear(std::uint8_t value, bool framing_error) {
  if (!is_on(receiver_enable)) {
    return;
  }
  if (heard_.size() == receiver_capacity) {
    ++core_.statistics().overruns;
    has_overrun_ = true;
    return;
  }
  heard_.push_back({value, framing_error, has_overrun_});
  has_overrun_ = false;
  show_receiver();
}

std::uint8_t AvrUart::read_data() {
  if (!heard_.empty()) {
    last_read_ = heard_.front().value;
    heard_.pop_front();
    show_receiver();
  }
  return last_read_;
}

void AvrUart::write_data(avr_io_addr_t, std::uint8_t value) {
  if (!is_on(transmitter_enable)) {
    core_.complain("a character was written to the transmitter while it is off");
  } else if (is_buffer_full_) {
    core_.complain("a character was written to the full transmitter");
  } else if (is_shifting_) {
    buffer_ = value;
    is_buffer_full_ = true;
    show_transmitter();
  } else {
    begin_frame(value, avr_.cycle);
    call_after<&AvrUart::end_frame>(avr_, frame_cycles(), *this);
    core_.stop();
  }
}

void AvrUart::begin_frame(std::uint8_t value, Cycle at) {
  is_shifting_ = true;
  if (start_) {
    start_(value, at);
  }
}

avr_cycle_count_t AvrUart::end_frame(avr_cycle_count_t when) {
  if (!is_buffer_full_) {
    is_shifting_ = false;
    core_.interrupts().raise(uart_.txc);
    return 0;
  }
  is_buffer_full_ = false;
  show_transmitter();
  begin_frame(buffer_, when);
  core_.stop();
  return when + frame_cycles();
}

void AvrUart::write_status(avr_io_addr_t address, std::uint8_t value) {
  const std::uint8_t kept = avr_.data[address] & static_cast<std::uint8_t>(~writable_status);
  avr_.data[address] = static_cast<std::uint8_t>(kept | (value & writable_status));
  if ((value & transmit_complete) != 0) {
    put_status(transmit_complete, false);
    core_.interrupts().withdraw(uart_.txc);
  }
}

void AvrUart::write_control(avr_io_addr_t address, std::uint8_t value) {
  avr_.data[address] = value & static_cast<std::uint8_t>(~received_ninth_bit);
  if (!is_on(receiver_enable)) {
    heard_.clear();
    has_overrun_ = false;
  }
  show_receiver();
  show_transmitter();
  if (!is_on(transmit_complete_interrupt)) {
    core_.interrupts().withdraw(uart_.txc);
  } else if ((avr_.data[uart_.r_ucsra] & transmit_complete) != 0 && uart_.txc.pending == 0) {
    core_.interrupts().raise(uart_.txc);
  }
}

void AvrUart::write_plain(avr_io_addr_t address, std::uint8_t value) {
  avr_.data[address] = value;
}

void AvrUart::show_receiver() {
  put_status(receive_complete, !heard_.empty());
  put_status(frame_error, !heard_.empty() && heard_.front().framing_error);
  put_status(data_overrun, !heard_.empty() && heard_.front().after_overrun);
  core_.interrupts().update(uart_.rxc);
}

void AvrUart::show_transmitter() {
  put_status(data_empty, !is_buffer_full_);
  core_.interrupts().update(uart_.udrc);
}

Cycle AvrUart::bit_cycles() const {
  const unsigned divider = avr_.data[uart_.ubrrl.reg] | (avr_.data[uart_.ubrrh.reg] & 0x0FU) << 8;
  const bool is_double = (avr_.data[uart_.r_ucsra] & double_speed) != 0;
  return Cycle{is_double ? 8U : 16U} * (divider + 1);
}

Cycle AvrUart::frame_cycles() const {
  const std::uint8_t format = avr_.data[uart_.r_ucsrc];
  const unsigned data_bits = is_on(ninth_bit) ? 9U : 5U + (format >> 1 & 3U);
  const unsigned parity_bits = (format & parity_mode) != 0 ? 1 : 0;
  const unsigned stop_bits = (format & two_stop_bits) != 0 ? 2 : 1;
  return bit_cycles() * (1 + data_bits + parity_bits + stop_bits);
}

void AvrUart::put_status(std::uint8_t bits, bool is_up) {
  std::uint8_t& status = avr_.data[uart_.r_ucsra];
  status = static_cast<std::uint8_t>(is_up ? status | bits : status & ~bits);
}

bool AvrUart::is_on(std::uint8_t control_bit) const {
  return (avr_.data[uart_.r_ucsrb] & control_bit) != 0;
}

}  // namespace simulation
