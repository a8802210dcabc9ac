#include "drivers/host/machine.hpp"

namespace drivers {
namespace host {

namespace {

thread_local Machine* current = nullptr;

}  // namespace

bool Machine::hear(std::uint8_t value, bool is_spoiled) {
  const base::TurnSender::Heard kind = sender.hear(value, is_spoiled);
  if (kind == base::TurnSender::Heard::echo || kind == base::TurnSender::Heard::clash) {
    return false;
  }
  base::HeardByte byte;
  byte.value = value;
  byte.is_spoiled = is_spoiled || lost_one_;
  byte.at = stamp;
  lost_one_ = !heard.put(byte);
  is_loop_called = lost_one_ || wake_count.heard() || byte.is_spoiled || is_loop_called;
  return true;
}

void select(Machine& machine) {
  current = &machine;
}

Machine& selected() {
  return *current;
}

}  // namespace host
}  // namespace drivers
