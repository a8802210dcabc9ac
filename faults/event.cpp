#include "faults/event.hpp"

namespace faults {

void EventRing::record(uint8_t code, uint8_t argument, base::Instant now) {
  const Event last = newest(0);
  count(total_);
  if (last.code == code && last.argument == argument) {
    count(repeats_);
    return;
  }
  repeats_ = 0;
  const uint8_t place = static_cast<uint8_t>(next_ % capacity);  // H-27: inside, whatever has become of it
  events_[place].code = code;
  events_[place].argument = argument;
  events_[place].at = now;
  next_ = static_cast<uint8_t>((place + 1U) % capacity);
}

Event EventRing::newest(uint8_t back) const {
  if (back >= capacity) {
    return Event();
  }
  return events_[static_cast<uint8_t>((next_ + capacity - 1U - back) % capacity)];
}

}  // namespace faults
