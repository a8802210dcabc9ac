// drivers/base: time across its wraps, bits, one's own turn on the line.
#include "drivers/base/bits.hpp"
#include "drivers/base/time.hpp"
#include "drivers/base/turn_sender.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using namespace base;  // literals

namespace {

template <typename Span>
void compare(Record& record, Span age, Span limit) {
  record.add(age >= limit);
  record.add(age > limit);
  record.add(age <= limit);
  record.add(age < limit);
  record.add(age == limit);
  record.add((age + limit).count());
  record.add((age - limit).count());
}

template <typename Point, typename Span>
void pass_time(Record& record, Point now, Point then, Span limit) {
  record.add((now - then).count());
  record.add((now + limit).count());
  record.add(now == then);
  compare(record, now - then, limit);
}

template <typename Point, typename Span, uint8_t N>
void pass_all(Record& record, const typename Point::rep (&moments)[N]) {
  for (uint8_t now = 0; now < N; ++now) {
    for (uint8_t then = 0; then < N; ++then) {
      pass_time(record, Point(moments[now]), Point(moments[then]), Span(moments[static_cast<uint8_t>(N - 1 - then)]));
    }
  }
}

}  // namespace

void instants(Record& record) {
  const uint32_t moments[] = {0,     1,          2,          99,         100,        32767,      32768,
                              65535, 0x7FFFFFFF, 0x80000000, 0xFFFF0000, 0xFFFFFF9B, 0xFFFFFF9C, 0xFFFFFFFF};
  pass_all<Instant, Millis>(record, moments);
  Random random(1);
  for (uint16_t i = 0; i < 500; ++i) {
    const Instant now(random.double_word());
    const Millis age(random.word());
    const Millis limit(random.word());
    pass_time(record, now + age, now, limit);
  }
  record.known(static_cast<int32_t>((Instant(5) - Instant(0xFFFFFFFB)).count()), 10);
  record.known(Instant(99) - Instant(0xFFFFFFFF) >= 100_ms, 1);
  record.known(Instant(98) - Instant(0xFFFFFFFF) >= 100_ms, 0);
  record.known(static_cast<int32_t>((70_s).count()), 70000);
  record.known(static_cast<int32_t>((Instant(65535) + 1_ms).count()), 65536);
}

void stamps(Record& record) {
  const uint16_t moments[] = {0,     1,     2,     2999,  3000,  3001,  32767, 32768,
                              40000, 61249, 61250, 61251, 62535, 62536, 65534, 65535};
  pass_all<Stamp, Micros>(record, moments);
  Random random(2);
  for (uint16_t i = 0; i < 500; ++i) {
    const Stamp now(random.word());
    const Stamp then(random.word());
    const Micros limit(random.word());
    pass_time(record, now, then, limit);
  }
  record.known((Stamp(100) - Stamp(65500)).count(), 136);
  record.known(Stamp(100) - Stamp(65500) >= 60_us, 1);
  record.known(Stamp(2463) - Stamp(65000) >= 3000_us, 0);  // 536 + 2463 = 2999
  record.known(Stamp(2464) - Stamp(65000) >= 3000_us, 1);
  record.known((Stamp(65500) + 100_us).count(), 64);
  record.known((Stamp(40000) - Stamp(0)).count(), 40000);
}

void fields(Record& record) {
  for (uint8_t high = 0; high <= 6; ++high) {
    for (uint8_t low = 0; low <= high; ++low) {
      const Field field{1, high, low};
      record.add(field.mask());
      record.add(field.maximum());
      for (uint16_t value = 0; value <= 255; ++value) {
        uint8_t data[2] = {static_cast<uint8_t>(value), static_cast<uint8_t>(value)};
        record.add(read(data, field));
        record.add(is_set(data, field));
        data[1] = 0;
        put(data, field, static_cast<uint8_t>(value));
        record.add(data[1]);
      }
    }
  }
  record.known(Field{0, 6, 0}.mask(), 0x7F);
  record.known(Field{0, 6, 4}.mask(), 0x70);
  record.known(Field{0, 6, 4}.maximum(), 7);
}

void turn_sender(Record& record) {
  const uint8_t turn[] = {0x05, 0x80, 0xFA, 0x0F};
  Random random(3);
  TurnSender sender;
  for (uint16_t i = 0; i < 5000; ++i) {
    uint8_t value = random.any_of(turn);
    switch (random.below(8)) {
      case 0:
        if (sender.state() != TurnSender::State::speaking) {
          sender.hush();
          sender.load(Span<const uint8_t>(turn, static_cast<uint8_t>(random.below(5))));
          sender.arm(0x0F, random.one_in(2));
        }
        break;
      case 1:
        record.add(static_cast<uint8_t>(sender.hear(0x0F, random.one_in(4))));
        break;
      case 2:
        record.add(static_cast<uint8_t>(sender.hear(value, random.one_in(8))));
        break;
      case 3:
        if (random.one_in(4)) {
          sender.hush();
        }
        record.add(sender.take_clash());
        break;
      case 4:
        if (!sender.has_more()) {
          sender.finished();
        }
        break;
      default:
        record.add(sender.next(value));
        record.add(value);
        record.add(static_cast<uint8_t>(sender.hear(value, false)));
        break;
    }
    record.add(static_cast<uint8_t>(sender.state()));
    record.add(sender.has_more());
  }

  TurnSender fresh;
  uint8_t value = 0;
  fresh.load(Span<const uint8_t>(turn, 4));
  fresh.arm(0x0F, true);
  record.known(fresh.next(value), 0);
  record.known(static_cast<uint8_t>(fresh.hear(0x0F, true)), 0);   // spoiled, so it starts nothing
  record.known(static_cast<uint8_t>(fresh.hear(0x0F, false)), 1);  // start
  record.known(fresh.next(value), 1);
  record.known(value, 0x05);
  record.known(static_cast<uint8_t>(fresh.hear(0x05, false)), 2);  // echo
  record.known(fresh.next(value), 1);
  record.known(static_cast<uint8_t>(fresh.hear(0x81, false)), 3);  // clash: 0x80 was sent
  record.known(fresh.next(value), 0);
}

}  // namespace vectors
