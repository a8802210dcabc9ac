#include "faults/heartbeat.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace faults {
namespace {

using base::Micros;
using base::Stamp;

constexpr Beat all_beats[] = {Beat::receive, Beat::tick, Beat::step, Beat::output, Beat::self_test};

Beats all_but(std::vector<Beat> missing = {}) {
  Beats beats;
  for (const Beat beat : all_beats) {
    beats.add(beat);
  }
  for (const Beat beat : missing) {
    beats.put(beat, false);
  }
  return beats;
}

// How often the watchdog is fed in `rounds` of 2 ms with these beats in each.
int feedings(Heartbeat& heart, Beats beats, int rounds, std::uint16_t apart = 2000) {
  Stamp now(60000);  // so that the stamp wraps under way
  int count = 0;
  for (int i = 0; i < rounds; ++i) {
    now = now + Micros(apart);
    heart.report(beats);
    count += heart.take(now) ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("the watchdog is fed while everybody works", "[H-25]") {
  Heartbeat heart;
  CHECK(feedings(heart, all_but(), 1000) == 1000);
}

TEST_CASE("one missing beat starves the watchdog, whichever it is", "[H-25]") {
  const Beat quick = GENERATE(Beat::receive, Beat::tick, Beat::step, Beat::output);
  CAPTURE(static_cast<int>(quick));
  Heartbeat heart;
  CHECK(feedings(heart, all_but({quick}), 1000) == 0);
  // It worked once: that is good for one feeding, and no more.
  heart.report(Beats::of(quick));
  CHECK(feedings(heart, all_but({quick}), 1000) == 1);
}

TEST_CASE("without a self-test the watchdog is fed for 20 ms, and then no more", "[H-25][H-27]") {
  Heartbeat heart;
  CHECK(feedings(heart, all_but({Beat::self_test}), 100) == 0);
  heart.report(Beats::of(Beat::self_test));
  CHECK(feedings(heart, all_but({Beat::self_test}), 100) == 10);
}

TEST_CASE("beats may come one after the other; what is fed is spent", "[H-25]") {
  Heartbeat heart;
  Stamp now(5000);
  for (const Beat beat : all_beats) {
    CHECK_FALSE(heart.take(now));
    heart.report(Beats::of(beat));
  }
  CHECK(heart.take(now));
  now = now + Micros(2000);
  CHECK_FALSE(heart.take(now));
}

TEST_CASE("a loop that turns too fast, or a second clock that stands still, starves the watchdog", "[H-24][H-25]") {
  Heartbeat heart;
  CHECK(feedings(heart, all_but(), 1000, 0) == 1);     // it stands still
  CHECK(feedings(heart, all_but(), 1000, 100) <= 67);  // not more than one in 1.5 ms
  CHECK(feedings(heart, all_but(), 1000, 1499) <= 501);
  CHECK(feedings(heart, all_but(), 1000, 1500) >= 999);
}

}  // namespace faults
