// spm: the battery's voltage as the gauge shows it.
#include "spm/fuel_gauge.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"
#include "tests/vectors/settings.hpp"

namespace vectors {

using base::Instant;
using base::Millis;
using base::Millivolts;
using spm::FuelGauge;
using spm::Settings;

namespace {

// The gauge after `count` readings of the same voltage, one each 100 ms from the start.
uint8_t after(FuelGauge& gauge, Instant& now, uint16_t millivolts, uint8_t count) {
  for (uint8_t i = 0; i < count; ++i) {
    now = now + Millis(100);
    gauge.step(Millivolts(millivolts), Settings(), now);
  }
  return gauge.value();
}

uint8_t shown_at(uint16_t millivolts) {
  FuelGauge gauge;
  Instant now(0xFFFFFF00);
  gauge.start(now);
  return after(gauge, now, millivolts, 5);
}

}  // namespace

void fuel_gauge(Record& record) {
  for (uint32_t millivolts = 21000; millivolts <= 26000; millivolts += 10) {
    record.add(shown_at(static_cast<uint16_t>(millivolts)));
  }
  for (uint32_t millivolts = 0; millivolts <= 65535; millivolts += 257) {
    record.add(shown_at(static_cast<uint16_t>(millivolts)));
  }
  Random random(15);
  for (uint8_t i = 0; i < 40; ++i) {
    const Settings settings = any_extremes(random);
    FuelGauge gauge;
    Instant now(0xFFFFF000);
    gauge.start(now);
    uint16_t millivolts = random.word();
    for (uint8_t j = 0; j < 100; ++j) {
      now = now + Millis(99U + random.below(3));
      if (random.one_in(8)) {
        millivolts = random.word();
      }
      gauge.step(Millivolts(millivolts), settings, now);
      record.add(gauge.value());
    }
  }

  FuelGauge gauge;
  Instant now;
  gauge.start(now);
  record.known(after(gauge, now, 24000, 4), 0);   // not settled before 500 ms
  record.known(after(gauge, now, 24000, 1), 10);  // 1500 * 19 / 2800 = 10.18
  record.known(after(gauge, now, 20000, 1), 9);   // filtered to 23875
  record.known(shown_at(0), 0);
  record.known(shown_at(22500), 0);
  record.known(shown_at(25152), 17);  // 2652 * 19 / 2800 = 17.996
  record.known(shown_at(25153), 18);
  record.known(shown_at(40000), 18);
  record.known(shown_at(65535), 18);
}

}  // namespace vectors
