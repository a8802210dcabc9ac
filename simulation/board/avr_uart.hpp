// A USART in asynchronous mode, in place of simavr's: true frame length, a transmitter of buffer and shift
// register, a receiver that holds three characters, flags and interrupts as levels. Characters of 5 to 8 bits.
#pragma once

#include <deque>
#include <functional>

#include "simulation/board/avr_core.hpp"

namespace simulation {

class AvrUart {
 public:
  // `start` is called at the cycle at which a character's start bit begins on the transmit pin.
  using Start = std::function<void(std::uint8_t value, Cycle at)>;

  AvrUart(AvrCore& core, char name);
  void on_start(Start start) { start_ = std::move(start); }

  // A character has been received; nothing happens while the receiver is off.
  void hear(std::uint8_t value, bool framing_error);

  Cycle bit_cycles() const;

 private:
  struct Heard {
    std::uint8_t value;
    bool framing_error;
    bool after_overrun;
  };

  void reset();
  void write_data(avr_io_addr_t, std::uint8_t value);
  void write_status(avr_io_addr_t, std::uint8_t value);
  void write_control(avr_io_addr_t, std::uint8_t value);
  void write_plain(avr_io_addr_t address, std::uint8_t value);
  std::uint8_t read_data();

  void begin_frame(std::uint8_t value, Cycle at);
  avr_cycle_count_t end_frame(avr_cycle_count_t when);
  Cycle frame_cycles() const;
  void show_receiver();
  void show_transmitter();
  void put_status(std::uint8_t bits, bool is_up);
  bool is_on(std::uint8_t control_bit) const;

  AvrCore& core_;
  avr_t& avr_;
  avr_uart_t& uart_;
  Start start_;

  std::deque<Heard> heard_;  // two in the buffer and one in the shift register
  bool has_overrun_ = false;
  std::uint8_t last_read_ = 0;

  bool is_shifting_ = false;
  bool is_buffer_full_ = false;
  std::uint8_t buffer_ = 0;
};

}  // namespace simulation
