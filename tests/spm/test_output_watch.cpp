// Outputs against their currents (H-10, H-13): the watch by itself, then what the power module makes of it.
#include "spm/output_watch.hpp"

#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace spm;
using namespace support;

constexpr auto none = FaultSet();
constexpr auto left_motor = FaultSet::of(Fault::left_motor);
constexpr auto right_motor = FaultSet::of(Fault::right_motor);
constexpr auto brake = FaultSet::of(Fault::brake);

struct Rig {
  OutputWatch watch;
  Inputs in;
  Outputs out;

  Rig() {
    in.analog_ready = true;
    in.battery = base::Millivolts(24000);
  }

  void release() {
    out.left_brake = out.right_brake = Brake::released;
    out.bridge_enabled = true;
  }
  // So many looks at that current.
  FaultSet motors(int left, int right, int looks) {
    in.left_current = base::Milliamps(left);
    in.right_current = base::Milliamps(right);
    return read(looks);
  }
  FaultSet coils(int current, int looks) {
    in.brake_coils = base::Milliamps(current);
    return read(looks);
  }
  FaultSet read(int looks) {
    for (int i = 0; i < looks; ++i) {
      watch.step(in, out);
    }
    return watch.faults();
  }
};

TEST_CASE("more than 5 A in four looks in a row while the bridge is off is a stuck output, in either direction",
          "[H-10]") {
  CHECK(Rig().motors(5000, -5000, 100) == none);
  CHECK(Rig().motors(5001, 0, 3) == none);
  CHECK(Rig().motors(5001, 0, 4) == left_motor);
  CHECK(Rig().motors(-5001, 0, 4) == left_motor);
  CHECK(Rig().motors(0, 5001, 4) == right_motor);
  CHECK(Rig().motors(0, -5001, 4) == right_motor);
  CHECK(Rig().motors(99000, -99000, 4) == (left_motor | right_motor));
}

TEST_CASE("one reading within the limit starts the four over, and what was found stays found", "[H-10]") {
  Rig rig;
  CHECK(rig.motors(6000, 0, 3) == none);
  CHECK(rig.motors(5000, 0, 1) == none);
  CHECK(rig.motors(6000, 0, 3) == none);
  CHECK(rig.motors(6000, 0, 1) == left_motor);
  CHECK(rig.watch.must_cut());
  CHECK(rig.motors(0, 0, 1000) == left_motor);
  CHECK(rig.motors(6000, 0, 1000) == left_motor);
}

TEST_CASE("while the bridge is on only what no motor draws is a stuck output", "[H-10]") {
  const auto driven = [](int left, int right, int looks) {
    Rig rig;
    rig.release();
    rig.in.brake_coils = base::Milliamps(1300);
    return rig.motors(left, right, looks);
  };
  CHECK(driven(80000, -80000, 1000) == none);
  CHECK(driven(80001, 0, 3) == none);
  CHECK(driven(80001, 0, 4) == left_motor);
  CHECK(driven(0, -80001, 4) == right_motor);
}

TEST_CASE("readings that are not real yet accuse nobody", "[H-10][H-13]") {
  Rig rig;
  rig.in.analog_ready = false;
  rig.in.brake_coils = base::Milliamps(5000);
  CHECK(rig.motors(90000, 90000, 1000) == none);
}

TEST_CASE("two coils draw between 0.75 and 2 A at 24 V, for up to 9 looks in a row", "[H-13]") {
  const auto both = [](int current, int looks) {
    Rig rig;
    rig.release();
    return rig.coils(current, looks);
  };
  CHECK(both(750, 1000) == none);
  CHECK(both(2000, 1000) == none);
  CHECK(both(749, 9) == none);
  CHECK(both(749, 10) == brake);
  CHECK(both(2001, 9) == none);
  CHECK(both(2001, 10) == brake);
}

TEST_CASE("coils draw less from a low battery and when they are warm, and that is no fault; one alone still is",
          "[H-13][H-26]") {
  struct Case {
    int battery;
    int two_warm;  // 0.65 A at 24 V each, less 30 percent
    int one_cold;
  };
  for (const Case& one :
       {Case{18000, 683, 488}, Case{21000, 796, 569}, Case{24000, 910, 650}, Case{32000, 1213, 867}}) {
    CAPTURE(one.battery);
    for (const bool are_both : {true, false}) {
      Rig rig;
      rig.in.battery = base::Millivolts(static_cast<std::uint16_t>(one.battery));
      rig.release();
      CHECK(rig.coils(are_both ? one.two_warm : one.one_cold, 1000) == (are_both ? none : brake));
    }
  }
}

TEST_CASE("coils that are off draw less than half of one", "[H-13]") {
  CHECK(Rig().coils(325, 1000) == none);
  CHECK(Rig().coils(326, 9) == none);
  CHECK(Rig().coils(326, 10) == brake);
}

TEST_CASE("coils that were seen to be on for two looks have four to be wrong, and then all is cut", "[H-13]") {
  for (const int wrong : {749, 650, 0, 2001}) {
    Rig rig;
    rig.release();
    CHECK(rig.coils(1300, 1) == none);
    CHECK_FALSE(rig.watch.are_coils_on());
    CHECK(rig.coils(1300, 1) == none);
    CHECK(rig.watch.are_coils_on());
    CHECK(rig.coils(wrong, 3) == none);
    CHECK_FALSE(rig.watch.must_cut());
    CHECK(rig.coils(wrong, 1) == brake);
    CHECK(rig.watch.must_cut());
  }
}

TEST_CASE("coils that were never on are no reason to cut", "[H-13]") {
  Rig rig;
  rig.release();
  CHECK(rig.coils(650, 20) == brake);
  CHECK_FALSE(rig.watch.must_cut());
}

TEST_CASE("with each release the coils must be seen anew", "[H-13]") {
  Rig rig;
  rig.release();
  rig.coils(1300, 5);
  rig.out.left_brake = rig.out.right_brake = Brake::engaged;
  rig.out.bridge_enabled = false;
  rig.coils(0, 1);
  CHECK_FALSE(rig.watch.are_coils_on());
}

TEST_CASE("bridges are proven by four looks in a row with the relay closed and no current", "[H-10]") {
  Rig rig;
  CHECK(rig.motors(0, 0, 100) == none);
  CHECK_FALSE(rig.watch.are_bridges_proven());
  rig.out.relay_closed = true;
  CHECK(rig.motors(5000, -5000, 3) == none);
  CHECK_FALSE(rig.watch.are_bridges_proven());
  CHECK(rig.motors(0, 5001, 1) == none);
  CHECK(rig.motors(0, 0, 3) == none);
  CHECK_FALSE(rig.watch.are_bridges_proven());
  CHECK(rig.motors(0, 0, 1) == none);
  CHECK(rig.watch.are_bridges_proven());
  rig.out.relay_closed = false;
  rig.read(10);
  CHECK(rig.watch.are_bridges_proven());
}

TEST_CASE("a coil that agrees once in between is not accused", "[H-13]") {
  Rig rig;
  rig.release();
  rig.coils(650, 9);
  rig.coils(1300, 1);
  CHECK(rig.coils(650, 9) == none);
}

// ---- the whole power module

TEST_CASE("a stuck output switches relay and bridge off and brakes on at once, and is shown until power-down",
          "[H-10][SB-01.9][SB-2.16]") {
  Bench bench = Bench::driving();
  REQUIRE(bench.left() == 16384);
  bench.in.right_current = base::Milliamps(90000);
  const Microseconds begin = bench.now();
  while (!bench.is_still() && bench.now() - begin < 100000) {
    bench.run_us(500);
  }
  CHECK(bench.now() - begin >= 30000);
  CHECK(bench.now() - begin <= 42000);
  CHECK(bench.is_braked());
  CHECK_FALSE(bench.outputs().bridge_enabled);
  CHECK_FALSE(bench.outputs().relay_closed);
  bench.in.right_current = base::Milliamps(0);
  bench.cycle(wire::at_rest, 100);
  bench.cycle(wire::forward_fast, 100);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  CHECK_FALSE(bench.outputs().relay_closed);
  CHECK(bench.system_state() == 4);
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.is_limping());
  CHECK(bench.has_event(EventCode::right_motor));
  CHECK_FALSE(bench.has_event(EventCode::left_motor));
}

TEST_CASE("current in a motor of a chair at rest opens the relay", "[H-10][SB-01.9]") {
  Bench bench = Bench::ready();
  REQUIRE(bench.outputs().relay_closed);
  bench.in.left_current = base::Milliamps(-6000);
  bench.run_ms(29);
  CHECK(bench.outputs().relay_closed);
  bench.run_ms(13);
  CHECK_FALSE(bench.outputs().relay_closed);
  bench.in.left_current = base::Milliamps(0);
  bench.cycle(wire::at_rest, 20);
  CHECK_FALSE(bench.outputs().relay_closed);
  CHECK(bench.system_state() == 3);
  CHECK(bench.has_event(EventCode::left_motor));
}

TEST_CASE("a coil that is missing or shorted at a release never lets the chair pull away", "[H-13][SB-01.9]") {
  struct Case {
    std::int32_t left;
    std::int32_t right;
  };
  for (const Case& one : {Case{0, 650}, Case{650, 0}, Case{0, 0}, Case{3000, 650}, Case{650, 3000}}) {
    CAPTURE(one.left, one.right);
    Bench bench = Bench::ready();
    bench.left_coil = one.left;
    bench.right_coil = one.right;
    for (int i = 0; i < 100; ++i) {
      bench.cycle(wire::forward_fast);
      REQUIRE(bench.left() <= 16384 / 511);  // less than a step of duty
    }
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
    CHECK_FALSE(bench.outputs().relay_closed);
    CHECK(bench.system_state() == 5);
    CHECK(bench.has_event(EventCode::brake));
    bench.left_coil = bench.right_coil = 650;
    bench.cycle(wire::at_rest, 20);
    bench.cycle(wire::forward_fast, 50);
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
  }
}

TEST_CASE("a coil that fails while driving has its brake in: all is cut, both brakes go in together",
          "[H-13][SB-01.9]") {
  for (const std::int32_t current : {0, 3000}) {
    Bench bench = Bench::driving();
    bench.left_coil = current;
    const Microseconds begin = bench.now();
    while (!bench.is_braked() && bench.now() - begin < 100000) {
      bench.run_us(500);
    }
    CHECK(bench.now() - begin >= 29000);
    CHECK(bench.now() - begin <= 55000);
    CHECK(bench.is_still());
    CHECK_FALSE(bench.outputs().bridge_enabled);
    CHECK_FALSE(bench.outputs().relay_closed);
    bench.left_coil = 650;
    bench.cycle(wire::at_rest, 20);
    bench.cycle(wire::forward_fast, 50);
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
    CHECK(bench.system_state() == 5);
    CHECK(bench.has_event(EventCode::brake));
  }
}

// ---- before the first drive

TEST_CASE("before the first drive the brakes wait for four looks at motors that have supply and no bridge", "[H-10]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::at_rest, 4);
  REQUIRE_FALSE(bench.outputs().relay_closed);
  bench.hear(wire::at_rest + wire::tf);
  const Microseconds begin = bench.now();
  bench.run_ms(10);
  REQUIRE(bench.outputs().relay_closed);
  bench.hear(wire::forward_fast + wire::tf);
  while (bench.is_braked() && bench.now() - begin < 200000) {
    bench.run_us(500);
  }
  CHECK(bench.now() - begin >= 30000);
  CHECK(bench.now() - begin <= 50000);
}

TEST_CASE("a transistor that was shorted before the start is found before a brake opens", "[H-10][SB-01.9]") {
  Bench bench = Bench::greeted();
  bench.in.left_current = base::Milliamps(6000);  // though the relay is not even closed: a reading, no more
  for (int i = 0; i < 5; ++i) {
    bench.cycle(wire::at_rest);
  }
  for (int i = 0; i < 100; ++i) {
    bench.cycle(wire::forward_fast);
    REQUIRE(bench.is_braked());
    REQUIRE(bench.is_still());
  }
  CHECK(bench.system_state() == 3);
}

TEST_CASE("a drive after the first one does not wait again", "[H-10]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::forward_fast, 50);
  bench.cycle(wire::at_rest, 200);
  REQUIRE(bench.is_braked());
  bench.hear(wire::forward_fast + wire::tf);
  bench.run_ms(2);
  CHECK_FALSE(bench.is_braked());
}

TEST_CASE("torque waits until both coils were seen to be on, however short the brakes' time is", "[H-13]") {
  Settings settings;
  settings.set(Setting::brake_release_time, 20);
  Bench bench = Bench::ready(Bench(1000, settings));
  bench.left_coil = bench.right_coil = 360;  // 0.72 A: neither off nor on
  bench.cycle(wire::forward_fast, 3);
  CHECK_FALSE(bench.is_braked());
  CHECK(bench.is_still());
  bench.left_coil = bench.right_coil = 650;
  const Microseconds begin = bench.now();
  bench.hear(wire::forward_fast + wire::tf);
  while (bench.is_still() && bench.now() - begin < 100000) {
    bench.run_us(500);
  }
  CHECK(bench.now() - begin >= 9000);
  CHECK(bench.now() - begin <= 30000);
}

TEST_CASE("a coil that is on though it should be off forbids to drive", "[H-12][H-13]") {
  Bench bench = Bench::ready();
  bench.stray_coil = 650;
  bench.cycle(wire::at_rest, 6);
  CHECK(bench.system_state() == 5);
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
}

}  // namespace
