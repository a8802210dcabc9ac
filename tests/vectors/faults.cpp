// faults: the age of the last good message, and the log.
#include "faults/event.hpp"
#include "faults/link_supervisor.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using namespace base;  // literals
using faults::EventRing;
using faults::LinkSupervisor;

namespace {

// Both clocks of the board, a step of 250 us at a time.
struct Clocks {
  Instant now;
  Stamp stamp;
  uint8_t quarters = 0;

  void pass() {
    stamp = stamp + 250_us;
    quarters = static_cast<uint8_t>((quarters + 1) & 3);
    if (quarters == 0) {
      now = now + 1_ms;
    }
  }
};

void add_link(Record& record, const LinkSupervisor& link) {
  record.add((link.is_up() ? 1U : 0U) | (link.is_silent() ? 2U : 0U) | (link.has_corrupt_run() ? 4U : 0U));
}

}  // namespace

void link_supervisor(Record& record) {
  const LinkSupervisor::Limits limits{3, 61250_us, 5};
  LinkSupervisor link(limits);
  Clocks clocks{Instant(0xFFFFF000), Stamp(60000)};
  Random random(7);
  uint16_t until_message = 80;
  for (uint16_t i = 0; i < 20000; ++i) {
    clocks.pass();
    if (--until_message == 0) {
      until_message = static_cast<uint16_t>(random.one_in(8) ? 240 + random.below(600) : 80);
      switch (random.below(16)) {
        case 0:
          link.restarted();
          break;
        case 1:
          link.rest();
          break;
        case 2:
          link.sound();
          break;
        case 3:
        case 4:
        case 5:
          link.corrupt();
          break;
        default:
          link.message(clocks.now, clocks.stamp);
          break;
      }
    }
    link.poll(clocks.now, clocks.stamp);
    add_link(record, link);
  }

  LinkSupervisor fresh(limits);
  fresh.message(Instant(0xFFFFFFFF), Stamp(65000));
  fresh.poll(Instant(60), Stamp(60713));  // 61 ms later by one clock, 61 249 us by the other
  record.known(fresh.is_silent(), 0);
  fresh.poll(Instant(60), Stamp(60714));
  record.known(fresh.is_silent(), 1);
  record.known(fresh.is_up(), 0);
}

void event_ring(Record& record) {
  EventRing ring;
  Random random(8);
  for (uint16_t i = 0; i < 400; ++i) {
    const uint8_t code = static_cast<uint8_t>(1 + random.below(3));
    const uint8_t argument = static_cast<uint8_t>(random.below(2));
    ring.record(code, argument, Instant(i * 1000UL));
    const faults::Event event = ring.newest(static_cast<uint8_t>(random.below(18)));
    record.add(event.code);
    record.add(event.argument);
    record.add(event.at.count());
    record.add(ring.total());
    record.add(ring.repeats());
  }
  for (uint32_t i = 0; i < 66000; ++i) {
    ring.record(9, 0, Instant(i));
  }
  record.known(ring.total(), 65535);
  record.known(ring.repeats(), 65535);
  record.known(ring.newest(0).code, 9);
}

}  // namespace vectors
