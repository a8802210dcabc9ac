#include "spm/fuel_gauge.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace spm;
using namespace base;

struct Gauge {
  FuelGauge gauge;
  Settings settings;
  std::uint32_t now;

  explicit Gauge(std::uint32_t start = 0) : now(start) { gauge.start(Instant(start)); }
  int pass(int milliseconds, int at_rest) {
    for (int i = 0; i < milliseconds; ++i) {
      gauge.step(Millivolts(static_cast<std::uint16_t>(at_rest)), settings, Instant(++now));
    }
    return gauge.value();
  }
};

TEST_CASE("the gauge reads 0 for the first half second and the battery after it", "[SB-01.1]") {
  for (const std::uint32_t start : {0U, 12345U, 0xFFFFFFFFU - 250U}) {
    Gauge gauge(start);
    for (int i = 0; i < 499; ++i) {
      REQUIRE(gauge.pass(1, 25300) == 0);
    }
    CHECK(gauge.pass(120, 25300) == 18);
  }
}

TEST_CASE("the gauge sinks at once and rises only by what is more than a step", "[SB-01.1]") {
  Gauge gauge;
  CHECK(gauge.pass(700, 23990) == 10);  // 1490 * 19 / 2800 = 10.1
  CHECK(gauge.pass(30000, 23960) == 9);
  CHECK(gauge.pass(30000, 23990) == 9);
  CHECK(gauge.pass(30000, 24110) == 9);   // 10.9
  CHECK(gauge.pass(30000, 24140) == 10);  // 11.1
  CHECK(gauge.pass(30000, 23990) == 10);
}

TEST_CASE("a full battery is shown as full again, though it was not for a while", "[SB-01.1]") {
  Gauge gauge;
  CHECK(gauge.pass(700, 25100) == 17);
  CHECK(gauge.pass(60000, 25290) == 17);
  CHECK(gauge.pass(60000, 25400) == 18);
}

TEST_CASE("the gauge stays between 0 and 18 for every voltage there is", "[SB-01.1]") {
  for (int battery = 0; battery <= 65535; battery += 85) {
    const int value = Gauge().pass(700, battery);
    CAPTURE(battery);
    REQUIRE(value >= 0);
    REQUIRE(value <= 18);
    if (battery <= 22500) {
      REQUIRE(value == 0);
    }
    if (battery >= 25300) {
      REQUIRE(value == 18);
    }
  }
}

TEST_CASE("a fuller battery never reads less", "[SB-01.1]") {
  int before = 0;
  for (int battery = 22000; battery <= 26000; battery += 10) {
    const int value = Gauge().pass(700, battery);
    REQUIRE(value >= before);
    REQUIRE(value <= before + 1);
    before = value;
  }
  CHECK(before == 18);
}

TEST_CASE("half way between empty and full the gauge reads half", "[SB-01.1]") {
  CHECK(Gauge().pass(700, 23900) == 9);
}

TEST_CASE("the gauge follows slowly, so that a start of the motors does not empty it") {
  Gauge gauge;
  gauge.pass(1000, 25300);
  CHECK(gauge.pass(200, 20000) >= 14);
  CHECK(gauge.pass(200, 25300) >= 14);
  CHECK(gauge.pass(60000, 22000) == 0);
}

TEST_CASE("the scale is the settings'") {
  Gauge gauge;
  gauge.settings.set(Setting::battery_empty, 24000);
  gauge.settings.set(Setting::battery_full, 28000);
  CHECK(gauge.pass(700, 24000) == 0);
  CHECK(gauge.pass(60000, 26000) == 8);  // 9.5
  CHECK(gauge.pass(60000, 28100) == 18);
}

TEST_CASE("settings that contradict each other do not drive the gauge off its scale", "[SB-01.1][H-21]") {
  for (const int battery : {0, 20000, 23000, 26000, 30000, 65535}) {
    Gauge gauge;
    gauge.settings.set(Setting::battery_empty, 26000);
    gauge.settings.set(Setting::battery_full, 20000);
    const int value = gauge.pass(700, battery);
    CHECK(value >= 0);
    CHECK(value <= 18);
  }
}

}  // namespace
