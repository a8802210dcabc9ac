#include "faults/clock_watch.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace faults {
namespace {

using base::Instant;
using base::Stamp;

// Looks every 10 ms of the millisecond clock, which runs `ratio` times as fast as it should; true time, in
// milliseconds, until it is noticed; -1 if it never is. The microseconds run `other` times as fast.
double noticed_after(double ratio, double other = 1, int looks = 100000, std::uint32_t begin = 4294900000U) {
  ClockWatch watch;
  REQUIRE(watch.agree(Instant(begin), Stamp(777)));
  for (int i = 1; i <= looks; ++i) {
    const double milliseconds = i * 10 / ratio;
    const auto stamp = static_cast<std::uint16_t>(static_cast<std::uint64_t>(777 + milliseconds * 1000 * other));
    if (!watch.agree(Instant(begin + static_cast<std::uint32_t>(i) * 10), Stamp(stamp))) {
      return milliseconds;
    }
  }
  return -1;
}

}  // namespace

TEST_CASE("clocks that agree are never said to differ, not even when both wrap", "[H-24]") {
  CHECK(noticed_after(1) < 0);
  CHECK(noticed_after(1.009) < 0);
  CHECK(noticed_after(0.991) < 0);
}

TEST_CASE("a millisecond clock that is too fast or too slow is noticed", "[H-24]") {
  struct Row {
    double ratio;
    double most_ms;  // of true time
  };
  // OCR0A one or more bits off, the prescaler one step off: /8 and /256.
  const Row row = GENERATE(Row{1.02, 400}, Row{0.98, 400}, Row{1.04, 120}, Row{0.96, 120}, Row{2, 35}, Row{0.5, 35},
                           Row{8, 35}, Row{0.25, 41});
  CAPTURE(row.ratio);
  const double after = noticed_after(row.ratio);
  CHECK(after > 0);
  CHECK(after <= row.most_ms);
}

TEST_CASE("microseconds that are too fast, too slow or stand still are noticed", "[H-24]") {
  struct Row {
    double ratio;
    double most_ms;
  };
  const Row row = GENERATE(Row{0, 11}, Row{8, 11}, Row{0.125, 11}, Row{1.0 / 32, 11}, Row{1.03, 200}, Row{0.97, 200});
  CAPTURE(row.ratio);
  const double after = noticed_after(1, row.ratio);
  CHECK(after > 0);
  CHECK(after <= row.most_ms);
}

TEST_CASE("the grain of a millisecond and a loop held up for 2 ms do not count as a difference", "[H-24]") {
  ClockWatch watch;
  for (int i = 0; i < 100000; ++i) {
    const int late = i % 37 == 0 ? 2000 : i * 131 % 1000;
    const auto stamp = static_cast<std::uint16_t>(i * 10000 + late);
    REQUIRE(watch.agree(Instant(static_cast<std::uint32_t>(i) * 10), Stamp(stamp)));
  }
}

}  // namespace faults
