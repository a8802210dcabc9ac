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
  return host::selected().heard.take(byte);
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

TurnSender::State state() {
  return host::selected().sender.state();
}

bool take_clash() {
  return host::selected().sender.take_clash();
}

void refresh() {}

}  // namespace serial
}  // namespace drivers
