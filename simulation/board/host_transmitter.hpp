// The bus transmitter of the host board: the timing of drivers/avr/serial.cpp and of a UART with one character in its
// shift register and one in its buffer.
#pragma once

#include <cstdint>
#include <optional>

#include "drivers/base/turn_sender.hpp"
#include "simulation/time.hpp"

namespace simulation {

class HostTransmitter {
 public:
  static constexpr Time bit = 26us;  // divider 12 at 8 MHz
  static constexpr Time character = 11 * bit;
  // What drivers/avr/serial.cpp asks for, and what the chip's interrupts add to it.
  static constexpr Time interrupts = 15us;
  static constexpr Time from_receipt_to_answer = 44us + interrupts;
  static constexpr Time soon = 8us + interrupts;

  explicit HostTransmitter(base::TurnSender& sender) : sender_(&sender) {}

  // Call after everything that may have begun or hushed a turn; one that has begun leaves after `delay`.
  void follow(Time now, Time delay) {
    const bool is_speaking = sender_->state() == base::TurnSender::State::speaking;
    if (is_shifting_ || is_speaking == (due_ != Time::max())) {
      return;
    }
    due_ = is_speaking ? now + delay : Time::max();
  }

  // When act() wants to be called; Time::max() while idle.
  Time due() const { return due_; }

  // The character that begins at due(), if one does.
  std::optional<std::uint8_t> act() {
    const auto value = is_shifting_ ? buffer_ : take();
    is_shifting_ = value.has_value();
    if (!is_shifting_) {
      sender_->finished();
      due_ = Time::max();
      return value;
    }
    buffer_ = take();
    due_ += character;
    return value;
  }

 private:
  std::optional<std::uint8_t> take() {
    std::uint8_t value = 0;
    return sender_->next(value) ? std::optional(value) : std::nullopt;
  }

  base::TurnSender* sender_;
  Time due_ = Time::max();
  bool is_shifting_ = false;
  std::optional<std::uint8_t> buffer_;
};

}  // namespace simulation
