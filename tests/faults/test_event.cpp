#include "faults/event.hpp"

#include <catch2/catch.hpp>

namespace {

using base::Instant;
using faults::EventRing;

TEST_CASE("a new ring knows of nothing") {
  const EventRing ring;
  CHECK(ring.total() == 0);
  CHECK(ring.repeats() == 0);
  for (std::uint8_t back = 0; back < EventRing::capacity; ++back) {
    CHECK(ring.newest(back).code == 0);
  }
}

TEST_CASE("events come back newest first, with argument and time") {
  EventRing ring;
  ring.record(1, 10, Instant(100));
  ring.record(2, 20, Instant(200));
  CHECK(ring.newest(0).code == 2);
  CHECK(ring.newest(0).argument == 20);
  CHECK(ring.newest(0).at == Instant(200));
  CHECK(ring.newest(1).code == 1);
  CHECK(ring.newest(1).at == Instant(100));
  CHECK(ring.newest(2).code == 0);
  CHECK(ring.total() == 2);
}

TEST_CASE("the oldest event gives way once the ring is full") {
  EventRing ring;
  for (std::uint8_t i = 1; i <= EventRing::capacity + 3; ++i) {
    ring.record(i, 0, Instant(i));
  }
  for (std::uint8_t back = 0; back < EventRing::capacity; ++back) {
    CHECK(ring.newest(back).code == EventRing::capacity + 3 - back);
  }
  CHECK(ring.newest(EventRing::capacity).code == 0);
  CHECK(ring.newest(255).code == 0);
  CHECK(ring.total() == EventRing::capacity + 3);
}

TEST_CASE("an event that repeats is counted and pushes nothing out") {
  EventRing ring;
  ring.record(1, 0, Instant(1));
  for (int i = 0; i < 100; ++i) {
    ring.record(2, 5, Instant(10));
  }
  CHECK(ring.newest(0).code == 2);
  CHECK(ring.newest(1).code == 1);
  CHECK(ring.repeats() == 99);
  CHECK(ring.total() == 101);
}

TEST_CASE("the same code with another argument is another event") {
  EventRing ring;
  ring.record(2, 5, Instant(10));
  ring.record(2, 5, Instant(11));
  ring.record(2, 6, Instant(12));
  CHECK(ring.repeats() == 0);
  CHECK(ring.newest(0).argument == 6);
  CHECK(ring.newest(1).argument == 5);
}

TEST_CASE("the counters stop at their end instead of starting over") {
  EventRing ring;
  for (long i = 0; i < 70000; ++i) {
    ring.record(2, 5, Instant(10));
  }
  CHECK(ring.total() == 65535);
  CHECK(ring.repeats() == 65535);
}

}  // namespace
