#include "drivers/serial.hpp"

#include "drivers/host/machine.hpp"

namespace drivers {
namespace serial {

using base::TurnSender;

namespace {

bool make_idle(TurnSender& sender) {
  if (sender.state() == TurnSender::State::speaking) {
    return false;
  }
  sender.hush();
  return true;
}

}  // namespace

void start() {}

bool take(base::HeardByte& byte) {
  host::Machine& machine = host::selected();
  if (!machine.heard.take(byte)) {
    return false;
  }
  machine.wake_count.taken();
  return true;
}

void expect(uint8_t count) {
  host::Machine& machine = host::selected();
  machine.is_loop_called = machine.wake_count.expect(count) || machine.is_loop_called;
}

void arm(uint8_t terminator, base::Span<const uint8_t> turn) {
  TurnSender& sender = host::selected().sender;
  if (make_idle(sender)) {
    sender.load(turn);
    sender.arm(terminator, false);  // never too late here: no time passes while the firmware works
  }
}

void speak(base::Span<const uint8_t> turn) {
  TurnSender& sender = host::selected().sender;
  if (make_idle(sender)) {
    sender.load(turn);
    sender.begin();
  }
}

void hush() {
  host::selected().sender.hush();
}

void cut() {
  TurnSender& sender = host::selected().sender;
  sender.hush();
  sender.finished();
}

bool is_all_taken() {
  return host::selected().heard.empty();
}

TurnSender::State state() {
  return host::selected().sender.state();
}

bool take_clash() {
  return host::selected().sender.take_clash();
}

void refresh() {}

}  // namespace serial
}  // namespace drivers
