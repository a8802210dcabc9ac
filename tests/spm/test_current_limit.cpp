// Too much current, for a moment and for long (H-31): the limit by itself, then what the chair makes of it.
#include "spm/current_limit.hpp"

#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace spm;
using namespace support;

Wheels wheels(int left, int right) {
  return Wheels{Demand(static_cast<std::int16_t>(left)), Demand(static_cast<std::int16_t>(right))};
}

struct Rig {
  CurrentLimit limit;
  Inputs in;
  Wheels wanted;
  bool is_pushed_back = false;  // what is wanted is not what is given

  // What is left of a demand after so many looks at those currents.
  Wheels look(double left, double right, const Wheels& given, int looks = 1, bool is_at_rest = false) {
    in.left_current = base::Milliamps(static_cast<std::int32_t>(left * 1000));
    in.right_current = base::Milliamps(static_cast<std::int32_t>(right * 1000));
    for (int i = 0; i < looks; ++i) {
      limit.look(in, given, is_pushed_back ? wanted : given, is_at_rest);
    }
    return limit.bound(given);
  }
};

TEST_CASE("up to 60 A nothing is limited, and a motor that brakes never is", "[H-31]") {
  CHECK(Rig().look(59.9, -59.9, wheels(16384, -16384)) == wheels(16384, -16384));
  CHECK(Rig().look(-100, 100, wheels(16384, -16384)) == wheels(16384, -16384));
  CHECK(Rig().look(100, -100, wheels(0, 0)) == wheels(0, 0));
  CHECK_FALSE(Rig().limit.is_acting());
}

TEST_CASE("above 60 A the demand shrinks in both directions; far above it is halved at once", "[H-31][H-10]") {
  const Wheels some = Rig().look(64, 0, wheels(10000, 10000));
  CHECK(some.left < Demand(9800));
  CHECK(some.left > Demand(9600));
  CHECK(some.right == Demand(10000));
  CHECK(Rig().look(0, -64, wheels(-10000, -10000)).right > Demand(-9800));
  CHECK(Rig().look(75, 75, wheels(16384, 16384)) == wheels(8192, 8192));
  CHECK(Rig().look(-125, 0, wheels(-9001, 7)) == wheels(-4500, 7));
  CHECK(Rig().look(70, 0, wheels(100, 100)).left == Demand(0));
}

TEST_CASE("a little above the limit both wheels shrink in proportion, no faster than in an emergency stop", "[H-31]") {
  const Wheels one = Rig().look(61, 0, wheels(10000, 5000));
  CHECK(one.left < Demand(9950));
  CHECK(one.left >= Demand(10000 - 128));
  CHECK(one.right < Demand(4990));
  CHECK(one.right >= Demand(4900));
  const Wheels spot = Rig().look(0, -61, wheels(8000, -8000));
  CHECK(spot.right > Demand(-7950));
  CHECK(spot.left < Demand(7980));
  CHECK(spot.left >= Demand(7850));
}

TEST_CASE("a demand only shrinks and keeps its sign, whatever the currents say", "[H-31][H-33]") {
  for (int demand = -16384; demand <= 16384; demand += 512) {
    for (int amps = -130; amps <= 130; amps += 3) {
      Rig rig;
      rig.look(60, 60, wheels(16384, 16384), 100 * (amps & 15));
      const Wheels given = wheels(demand, 3000 - demand / 2);
      const Wheels left = rig.look(amps, -amps, given);
      CAPTURE(demand, amps);
      REQUIRE(std::abs(left.left.count()) <= std::abs(given.left.count()));
      REQUIRE(std::abs(left.right.count()) <= std::abs(given.right.count()));
      REQUIRE(left.left.count() * demand >= 0);
      REQUIRE(left.right.count() * given.right.count() >= 0);
      const Wheels other = rig.limit.bound(wheels(-demand, 16384));
      REQUIRE(std::abs(other.left.count()) <= std::abs(demand));
      REQUIRE(other.right >= Demand(0));
    }
  }
}

TEST_CASE("a winding takes 16 A for ever, 60 A for 5 to 7 s before it is half-way hot", "[H-31]") {
  const auto looks_until = [](std::uint8_t current, std::uint16_t temperature) {
    Winding winding;
    int looks = 0;
    for (; winding.temperature() < temperature && looks < 1000000; ++looks) {
      winding.take(current);
    }
    return looks;
  };
  CHECK(looks_until(62, 242) == 1000000);  // 15.9 A
  CHECK(looks_until(234, 120) > 125);
  CHECK(looks_until(234, 120) < 175);
  Winding winding;
  for (int i = 0; i < 750; ++i) {
    winding.take(255);
  }
  const int hot = winding.temperature();
  for (int i = 0; i < 2840; ++i) {  // 164 s times the natural logarithm of 2
    winding.take(0);
  }
  CHECK(winding.temperature() == Approx(hot / 2).margin(10));
  for (int i = 0; i < 1000000; ++i) {
    winding.take(255);
  }
  CHECK(winding.temperature() == Approx(255 * 255 / 16).margin(5));
}

// The current that is let through after so long at that one.
double limit_after(double amps, int looks) {
  Rig rig;
  rig.look(amps, 0, wheels(16000, 0), looks);
  double held = 12;  // few looks more, which warm it up
  while (held < 70 && rig.look(held, 0, wheels(16000, 0)).left == Demand(16000)) {
    held += 0.25;
  }
  return held;
}

TEST_CASE("current over time: the limit sinks from the peak to the continuous current", "[H-31]") {
  CHECK(limit_after(59, 400) == Approx(60).margin(0.5));
  CHECK(limit_after(59, 800) < 50);
  CHECK(limit_after(59, 800) > 35);
  CHECK(limit_after(59, 2000) == Approx(16).margin(0.5));
  CHECK(limit_after(15, 100000) > 16);
  CHECK(limit_after(8, 100000) == Approx(60).margin(0.5));
}

TEST_CASE("a motor that stands with all it may have is stalled, one that turns is not", "[H-31]") {
  const auto looks_until_stalled = [](int demand) {
    Rig rig;
    int looks = 0;
    for (double amps = 60; !rig.limit.is_stalled() && looks < 3000; ++looks) {
      const bool is_cut = rig.look(amps, amps, wheels(demand, demand)).left < Demand(static_cast<std::int16_t>(demand));
      amps = is_cut ? amps - 0.3 : amps + 0.05;
    }
    return looks;
  };
  CHECK(looks_until_stalled(2000) > 800);
  CHECK(looks_until_stalled(2000) < 1500);
  CHECK(looks_until_stalled(12000) == 3000);
}

TEST_CASE("a stall ends at rest and not before", "[H-31]") {
  Rig rig;
  rig.look(60, 0, wheels(5000, 5000), 1000);
  REQUIRE(rig.limit.is_stalled());
  rig.look(0, 0, wheels(0, 0), 1000);
  CHECK(rig.limit.is_stalled());
  rig.look(0, 0, wheels(0, 0), 1, true);
  CHECK_FALSE(rig.limit.is_stalled());
}

TEST_CASE("braking is not limited, but what only braking can heat stops the chair until it has cooled", "[H-31]") {
  Rig rig;
  rig.look(-15, 0, wheels(9000, 9000), 100000);
  CHECK_FALSE(rig.limit.is_stalled());
  rig.look(-25, 0, wheels(9000, 9000), 100000);
  CHECK(rig.limit.is_stalled());
  rig.look(0, 0, wheels(0, 0), 100, true);
  CHECK(rig.limit.is_stalled());
  rig.look(0, 0, wheels(0, 0), 12000, true);
  CHECK_FALSE(rig.limit.is_stalled());
}

// ---- the whole power module, with motors that stand: 24 V, 0.15 ohm

void stall(Bench& bench, const Bytes& stick, int cycles) {
  for (int i = 0; i < cycles * 10; ++i) {
    const auto current = [](int demand) { return base::Milliamps(demand * 160 / 16384 * 1000); };
    bench.in.left_current = current(bench.left());
    bench.in.right_current = current(bench.right());
    if (i % 10 == 0) {
      bench.hear(stick + wire::tf);
    }
    bench.run_ms(i % 10 == 0 ? 1 : 2);
  }
}

TEST_CASE("a hard stall at full speed is limited before it looks like a stuck output", "[H-31][H-10]") {
  Bench bench = Bench::driving();
  stall(bench, wire::forward_fast, 5);
  CHECK(bench.left() < 16384 * 62 / 160);
  CHECK(bench.left() > 16384 * 40 / 160);
  stall(bench, wire::forward_fast, 100);
  CHECK(bench.left() < 16384 * 62 / 160);
  CHECK(bench.system_state() == 0);
  CHECK_FALSE(bench.has_event(EventCode::left_motor));
  CHECK(bench.outputs().relay_closed);
}

TEST_CASE("a stall stops the chair with state 01 until neutral, and it drives again after it",
          "[H-31][SB-01.9][SB-01.3]") {
  Bench bench = Bench::driving();
  stall(bench, wire::forward_fast, 700);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  CHECK(bench.system_state() == 1);
  CHECK(bench.is_neutral_demanded());
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.has_event(EventCode::stalled));
  bench.in.left_current = bench.in.right_current = base::Milliamps(0);
  bench.cycle(wire::forward_fast, 500);
  CHECK(bench.is_still());
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_inhibit_shown());
  bench.cycle(wire::at_rest, 6);
  CHECK(bench.system_state() == 0);
  CHECK_FALSE(bench.is_neutral_demanded());
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.left() > 1000);
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("when a stall gives way the chair goes on by its own ramp", "[H-31][H-33]") {
  Bench bench = Bench::driving();
  stall(bench, wire::forward_fast, 50);
  const int before = bench.left();
  bench.in.left_current = bench.in.right_current = base::Milliamps(0);
  bench.cycle(wire::forward_fast, 10);
  CHECK(bench.left() - before <= 520);  // 145 permille a second, 200 ms: 475
  CHECK(bench.left() - before >= 400);
}

TEST_CASE("a hot motor that is pushed back against what is wanted counts as standing, whatever is given",
          "[H-31][H-11]") {
  Rig rig;
  rig.is_pushed_back = true;
  rig.wanted = wheels(16384, 16384);
  for (int i = 0; i < 20000 && !rig.limit.is_stalled(); ++i) {  // 200 s of climbing at 18 A, faster than it stands
    rig.look(18, 18, wheels(12000, 12000));
  }
  REQUIRE_FALSE(rig.limit.is_stalled());
  int looks = 0;
  while (!rig.limit.is_stalled() && looks < 200) {  // rolling back: nothing is given, a little, nothing
    rig.look(30, 30, looks % 3 == 2 ? wheels(40, 40) : wheels(0, 0));
    ++looks;
  }
  CHECK(looks <= 60);
}

TEST_CASE("no flipped bit of a limit turns a wheel round", "[H-27][H-11]") {
  Rig rig;
  rig.look(75, 0, wheels(9000, 9000));  // one wheel is cut
  REQUIRE(rig.limit.is_acting());
  for (std::size_t bit = 0; bit < sizeof(CurrentLimit) * 8; ++bit) {
    CurrentLimit limit = rig.limit;
    auto* bytes = reinterpret_cast<unsigned char*>(&limit);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    CAPTURE(bit);
    const Wheels bound = limit.bound(wheels(9000, 9000));
    REQUIRE(bound.left >= Demand(0));
    REQUIRE(bound.right >= Demand(0));
    REQUIRE(bound.left <= Demand(9000));
    REQUIRE(bound.right <= Demand(9000));
  }
}

TEST_CASE("a winding whose heat has leapt cools all the same", "[H-27][H-31]") {
  for (int bit = 24; bit < 32; ++bit) {
    CAPTURE(bit);
    Rig rig;
    auto* bytes = reinterpret_cast<unsigned char*>(&rig.limit);  // the left winding's heat comes first
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    int seconds = 0;
    rig.look(0, 0, wheels(0, 0), 4);
    while (rig.limit.is_stalled() && seconds < 900) {
      rig.look(0, 0, wheels(0, 0), 100, true);
      ++seconds;
    }
    CHECK(seconds < 600);
  }
}

}  // namespace
