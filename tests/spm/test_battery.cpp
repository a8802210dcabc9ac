// The battery as the power module judges it (H-26): by itself, then what the chair makes of it.
#include "spm/battery.hpp"

#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace spm;
using namespace support;

constexpr auto none = FaultSet();
constexpr auto flat = FaultSet::of(Fault::battery_flat);
constexpr auto low = FaultSet::of(Fault::battery_low);
constexpr auto over = FaultSet::of(Fault::over_voltage);

struct Rig {
  Battery battery;
  Inputs in;
  Outputs out;
  Settings settings;

  Rig() { in.analog_ready = true; }
  void load(int duty, int amps) {
    out.left = out.right = Demand(static_cast<std::int16_t>(duty));
    in.left_current = in.right_current = base::Milliamps(amps * 1000);
    out.left_brake = out.right_brake = Brake::released;
  }
  FaultSet at(int millivolts, FaultSet known = none, int looks = 10) {  // 100 ms
    in.battery = base::Millivolts(static_cast<std::uint16_t>(millivolts));
    for (int i = 0; i < looks; ++i) {
      battery.step(in, out, settings, known);
    }
    return battery.faults();
  }
};

TEST_CASE("a battery is low below 21 V and flat below 18 V", "[H-26]") {
  CHECK(Rig().at(21000) == none);
  CHECK(Rig().at(20990) == low);
  CHECK(Rig().at(18000) == low);
  CHECK(Rig().at(17990) == (low | flat));
}

TEST_CASE("a low battery must recover by half a volt, a full one sink by that", "[H-26]") {
  CHECK(Rig().at(21480, low) == low);
  CHECK(Rig().at(21500, low) == none);
  CHECK(Rig().at(30500) == none);
  CHECK(Rig().at(30501) == over);
  CHECK(Rig().at(30001, over) == over);
  CHECK(Rig().at(30000, over) == none);
}

TEST_CASE("the load is allowed for: duty times current of both motors, times the battery's resistance", "[H-26]") {
  Rig rig;
  rig.load(8192, 40);  // half of twice 40 A, and 0.15 A: 40 A of 50 milliohms
  CHECK(rig.at(19100) == none);
  CHECK(rig.battery.at_rest().count() >= 21080);
  CHECK(rig.battery.at_rest().count() <= 21120);
  CHECK(rig.at(18900) == low);
  Rig braking;
  braking.load(8192, -40);
  CHECK(braking.at(22900) == low);
  CHECK(braking.at(23100) == none);
  Rig reverse;
  reverse.load(-8192, -40);
  CHECK(reverse.at(19100) == none);
  Rig unknown;
  unknown.settings.set(Setting::battery_resistance, 0);
  unknown.load(8192, 40);
  CHECK(unknown.at(20900) == low);
  CHECK(unknown.battery.at_rest() == base::Millivolts(20900));
}

TEST_CASE("no load explains more than 4 V: that battery is worn out", "[H-26]") {
  Rig rig;
  rig.settings.set(Setting::battery_resistance, 200);
  rig.load(16384, 60);
  CHECK(rig.at(16900) == low);
  CHECK(rig.at(13900) == (low | flat));
}

TEST_CASE("readings that are not real yet say nothing about the battery", "[H-26]") {
  Rig rig;
  rig.in.analog_ready = false;
  CHECK(rig.at(0) == none);
  CHECK(rig.battery.at_rest() == base::Millivolts(0));
}

TEST_CASE("a low battery slows down little by little to half, and speed comes back only with the brakes engaged",
          "[H-26][H-33]") {
  Rig rig;
  rig.load(0, 0);
  rig.at(20000, low, 10);
  CHECK(rig.battery.ceiling() == Demand(16302));
  rig.at(20000, low, 10);
  CHECK(rig.battery.ceiling() == Demand(16220));
  rig.at(20000, low, 1000);
  CHECK(rig.battery.ceiling() == Demand(8192));
  rig.at(25000, none, 1000);
  CHECK(rig.battery.ceiling() == Demand(8192));
  rig.out.left_brake = rig.out.right_brake = Brake::engaged;
  rig.at(25000, none, 10);
  CHECK(rig.battery.ceiling() == Demand(16384));
}

// ---- the whole power module

TEST_CASE("a low battery halves the acceleration, then the speed, and is shown", "[H-26][H-33][SB-01.9]") {
  Bench bench = Bench::driving();
  bench.in.battery = base::Millivolts(20500);
  bench.cycle(wire::forward_fast, 45);
  CHECK(bench.left() == 16384);
  CHECK(bench.system_state() == 0);
  bench.cycle(wire::forward_fast, 100);  // 2.9 s: 1.9 of them low
  CHECK(bench.system_state() == 2);
  CHECK(bench.has_event(EventCode::battery_low));
  CHECK_FALSE(bench.is_inhibit_shown());
  CHECK(bench.left() < 15300);
  CHECK(bench.left() > 14000);
  bench.cycle(wire::forward_fast, 500);
  CHECK(bench.left() == 8192);
  bench.in.battery = base::Millivolts(24000);
  bench.cycle(wire::forward_fast, 200);
  CHECK(bench.system_state() == 0);
  CHECK(bench.left() == 8192);  // H-33: it does not come back while driving
  bench.cycle(wire::at_rest, 200);
  REQUIRE(bench.is_braked());
  bench.cycle(wire::forward_fast, 400);
  CHECK(bench.left() == 16384);
}

TEST_CASE("with a low battery the chair pulls away half as fast", "[H-26]") {
  Bench bench = Bench::ready();
  bench.in.battery = base::Millivolts(20500);
  bench.cycle(wire::at_rest, 100);
  bench.cycle(wire::forward_fast, 5);
  const int begin = bench.left();
  bench.cycle(wire::forward_fast, 50);
  const int second = bench.left() - begin;  // 72.5 permille of full
  CHECK(second > 1100);
  CHECK(second < 1250);
}

TEST_CASE("over-voltage makes braking gentler, an emergency stop stays what it is", "[H-26][SB-2.17][H-03]") {
  const auto fall_of = [](int millivolts, bool is_emergency) {
    Bench bench = Bench::driving();
    bench.in.battery = base::Millivolts(static_cast<std::uint16_t>(millivolts));
    bench.cycle(wire::forward_fast, 6);
    if (millivolts > 30500) {
      CHECK(bench.system_state() == 2);
      CHECK(bench.has_event(EventCode::over_voltage));
    }
    CHECK_FALSE(bench.is_inhibit_shown());
    CHECK(bench.left() == 16384);
    if (is_emergency) {
      bench.run_ms(62);
    } else {
      bench.cycle(wire::at_rest, 1);
    }
    const int begin = bench.left();
    is_emergency ? bench.run_ms(500) : bench.cycle(wire::at_rest, 25);
    return begin - bench.left();
  };
  CHECK(fall_of(24000, false) == Approx(3932).margin(40));  // 480 permille a second
  CHECK(fall_of(31000, false) == Approx(2621).margin(40));  // 320
  CHECK(fall_of(31000, true) == Approx(6554).margin(40));   // 800
}

}  // namespace
