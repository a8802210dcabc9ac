// The product's arithmetic on the chip against the same on the host and against results known by hand: `int` has 16
// bits on one and 32 on the other, and only running both shows where that matters.
#include "tests/simulation/board/bench.hpp"
#include "tests/vectors/groups.hpp"

namespace simulation {
namespace {

using vectors::group_count;
using vectors::groups;
using vectors::Record;

constexpr Time patience = 300s;  // it takes about 80

Record on_host(unsigned group) {
  Record record;
  groups[group].run(record);
  return record;
}

// The chip after it has run all groups.
std::unique_ptr<Bench> on_target(const std::string& folder) {
  auto bench = std::make_unique<Bench>("vectors", std::vector<std::uint8_t>{0}, 0, folder);
  bench->start();
  do {
    bench->run(20ms);
  } while (bench->now < patience && bench->byte("current") < group_count &&
           bench->board->statistics().complaints.empty());
  const unsigned reached = bench->byte("current");
  INFO("stopped in group: " << (reached < group_count ? groups[reached].name : "none"));
  CHECK(bench->board->statistics().complaints == std::vector<std::string>{});
  REQUIRE(reached == group_count);
  return bench;
}

std::uint32_t double_word(const Bench& bench, const std::string& variable, unsigned index) {
  std::uint32_t value = 0;
  for (unsigned i = 4; i-- > 0;) {
    value = value << 8 | bench.byte(variable, 4 * index + i);
  }
  return value;
}

void compare_all(const Bench& bench) {
  for (unsigned group = 0; group < group_count; ++group) {
    const Record host = on_host(group);
    INFO("group: " << groups[group].name);
    CHECK(double_word(bench, "counts", group) == host.count());
    CHECK(double_word(bench, "digests", group) == host.digest());
    for (std::uint8_t i = 0; i < host.known_count(); ++i) {
      CAPTURE(int{i});
      CHECK(static_cast<std::int32_t>(double_word(bench, "known", group * Record::most_known + i)) == host.expected(i));
    }
  }
}

}  // namespace

TEST_CASE("on the host the vectors come to what is known by hand") {
  for (unsigned group = 0; group < group_count; ++group) {
    const Record record = on_host(group);
    INFO("group: " << groups[group].name);
    CHECK(record.count() > 0);
    REQUIRE(record.known_count() <= Record::most_known);
    for (std::uint8_t i = 0; i < record.known_count(); ++i) {
      CAPTURE(int{i});
      CHECK(record.actual(i) == record.expected(i));
    }
  }
}

TEST_CASE("the chip computes what the host computes") {
  compare_all(*on_target(PILOTFISH_TEST_FIRMWARE_DIR));
}

TEST_CASE("the chip computes the same without a single overflow, bad shift or bad index") {
  compare_all(*on_target(PILOTFISH_TRAPS_DIR));
}

}  // namespace simulation
