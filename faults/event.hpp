// What happened, in memory: the newest events, each with a code, an argument and its time.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"
#include "drivers/base/time.hpp"

namespace faults {

struct Event {
  uint8_t code = 0;  // 0 = no event
  uint8_t argument = 0;
  base::Instant at;
};

// Keeps the newest `capacity` events; the same event again and again only counts up, so that a chattering
// fault cannot push out what came before it.
class EventRing {
 public:
  static constexpr uint8_t capacity = 16;

  constexpr EventRing() : events_(), next_(0), total_(0), repeats_(0) {}

  void record(uint8_t code, uint8_t argument, base::Instant now);

  // 0 = the newest; a default Event beyond the oldest.
  Event newest(uint8_t back) const;
  // Events recorded since start, repeats included; stops at 65535.
  uint16_t total() const { return total_; }
  uint16_t repeats() const { return repeats_; }

 private:
  void count(uint16_t& counter) {
    if (counter != UINT16_MAX) {
      ++counter;
    }
  }

  base::Array<Event, capacity> events_;
  uint8_t next_;
  uint16_t total_;
  uint16_t repeats_;  // of the newest event
};

}  // namespace faults
