#include "drivers/serial.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/avr/board_spm.hpp"
#include "drivers/avr/bus_timer.hpp"
#include "drivers/avr/interrupt_lock.hpp"
#include "drivers/avr/loop_call.hpp"
#include "drivers/base/ring.hpp"
#include "drivers/base/wake_count.hpp"

namespace {

using base::TurnSender;

constexpr uint32_t baud = 38400;  // SB-2.1
constexpr uint16_t divider = (F_CPU + 8 * baud) / (16 * baud) - 1;
static_assert(divider == 12, "SB-2.1: 38462 bps from 8 MHz, 0.16 % fast");

// RXC rises when the first stop bit is sampled; the frame ends 1.4 bit times = 36 us later. The answer starts
// a little after that (SB-2.7), later by as much as interrupts take to respond.
constexpr uint16_t from_receipt_to_answer = 44;
constexpr uint16_t soon = 8;           // the line is idle already
constexpr uint16_t latest_arm = 1000;  // after a terminator's receipt; later the line may be somebody else's (SB-2.8)
// A little more than 3 ms after the end of the frame, so that the loop finds the silence long enough (SB-2.11).
constexpr uint16_t from_receipt_to_silence = 3045;

constexpr uint8_t receiving = _BV(RXCIE0) | _BV(RXEN0) | _BV(TXEN0);

base::Ring<base::HeardByte, 32> heard;
TurnSender sender;
bool lost_one = false;       // a character found no room in `heard`
uint16_t last_heard_at = 0;  // when somebody else's last character came
base::WakeCount wake_count;

}  // namespace

// A character has come from the line.
ISR(USART0_RX_vect) {
  const uint8_t status = UCSR0A;
  const uint8_t value = UDR0;
  const uint16_t at = TCNT3;
  const bool is_spoiled = (status & (_BV(FE0) | _BV(DOR0))) != 0;
  const TurnSender::Heard kind = sender.hear(value, is_spoiled);
  if (kind == TurnSender::Heard::echo || kind == TurnSender::Heard::clash) {
    return;
  }
  if (kind == TurnSender::Heard::start) {
    drivers::avr::schedule_turn(from_receipt_to_answer);
  }
  base::HeardByte byte;
  byte.value = value;
  byte.is_spoiled = is_spoiled || lost_one;
  byte.at = base::Stamp(at);
  last_heard_at = at;
  drivers::avr::schedule_silence(static_cast<uint16_t>(at + from_receipt_to_silence));
  lost_one = !heard.put(byte);
  if (lost_one || wake_count.heard() || byte.is_spoiled) {
    drivers::avr::call_loop();
  }
}

// The line has been silent. One instruction that touches no flag, so nothing needs to be saved.
ISR(TIMER3_COMPA_vect, ISR_NAKED) {
  drivers::avr::call_loop();
  reti();
}

// The moment for a turn to begin.
ISR(TIMER3_COMPB_vect) {
  drivers::avr::cancel_turn();
  uint8_t value;
  if (!sender.next(value)) {
    sender.finished();
    return;
  }
  UCSR0A = _BV(TXC0);  // cleared by writing one, so that it will mean the end of this turn
  UDR0 = value;
  UCSR0B = receiving | _BV(UDRIE0);
}

// Room for the next byte of the turn.
ISR(USART0_UDRE_vect) {
  uint8_t value;
  if (sender.next(value)) {
    UDR0 = value;
    return;
  }
  UCSR0B = receiving | _BV(TXCIE0);
}

// The last stop bit has left.
ISR(USART0_TX_vect) {
  UCSR0B = receiving;
  sender.finished();
}

namespace drivers {
namespace serial {

static void configure() {
  avr::BusTransmit::set();  // SB-1.1: recessive before the pin drives
  avr::BusTransmit::make_output();
  if (UBRR0 != divider) {  // writing it starts a bit anew
    UBRR0 = divider;
  }
  UCSR0A = 0;                                       // single speed; flags are cleared by ones
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00) | _BV(USBS0);  // SB-2.1: 8N2
}

void start() {
  configure();
  UCSR0B = receiving;
}

bool take(base::HeardByte& byte) {
  if (!heard.take(byte)) {
    return false;
  }
  wake_count.taken();
  return true;
}

void expect(uint8_t count) {
  avr::InterruptLock lock;
  if (wake_count.expect(count)) {
    avr::call_loop();
  }
}

// An idle sender is read by nobody, so its bytes can be copied with interrupts on.
static bool make_idle() {
  avr::InterruptLock lock;
  if (sender.state() == TurnSender::State::speaking) {
    return false;
  }
  sender.hush();
  return true;
}

void arm(uint8_t terminator, base::Span<const uint8_t> turn) {
  if (!make_idle()) {
    return;
  }
  sender.load(turn);
  avr::InterruptLock lock;
  const uint16_t age = static_cast<uint16_t>(TCNT3 - last_heard_at);
  if (sender.arm(terminator, age < latest_arm)) {
    avr::schedule_turn(age < from_receipt_to_answer - soon ? from_receipt_to_answer - age : soon);
  }
}

void speak(base::Span<const uint8_t> turn) {
  if (!make_idle()) {
    return;
  }
  sender.load(turn);
  avr::InterruptLock lock;
  sender.begin();
  avr::schedule_turn(soon);
}

void hush() {
  avr::InterruptLock lock;
  sender.hush();
  if (sender.state() == TurnSender::State::idle) {
    avr::cancel_turn();
  }
}

void cut() {
  avr::InterruptLock lock;
  avr::cancel_turn();
  sender.hush();
  sender.finished();
  UCSR0B = static_cast<uint8_t>(receiving & ~_BV(TXEN0));  // what is in the shift register still leaves
}

bool is_all_taken() {
  return heard.empty() && (UCSR0A & _BV(RXC0)) == 0;
}

TurnSender::State state() {
  avr::look_again();
  return sender.state();
}

bool take_clash() {
  avr::look_again();
  if (!sender.has_clashed()) {
    return false;
  }
  avr::InterruptLock lock;
  return sender.take_clash();
}

void refresh() {
  avr::InterruptLock lock;
  configure();
  const bool is_speaking = sender.state() == TurnSender::State::speaking;
  UCSR0B = static_cast<uint8_t>(receiving | (is_speaking ? UCSR0B & (_BV(UDRIE0) | _BV(TXCIE0)) : 0));
}

}  // namespace serial
}  // namespace drivers
