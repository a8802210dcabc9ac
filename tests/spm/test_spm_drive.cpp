// The power module as a driver: neutral first, everything that forbids to drive, operating modes, motion
// (SB-00.4 to SB-00.8, SB-01.8 to SB-01.10).
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

// ---- neutral first

TEST_CASE("a stick held from power-up on moves nothing, and the remote is told why", "[SB-01.8][SB-01.9][H-02]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::forward_fast, 100);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  CHECK(bench.is_neutral_demanded());
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.system_state() == 1);
  CHECK_FALSE(bench.is_driving_shown());
}

TEST_CASE("four generals at rest do not free the chair, five do", "[SB-01.8][H-02]") {
  Bench four = Bench::greeted();
  four.cycle(wire::at_rest, 4);
  CHECK(four.is_inhibit_shown());
  four.cycle(wire::forward_fast, 100);
  CHECK(four.is_still());

  Bench five = Bench::greeted();
  five.cycle(wire::at_rest, 5);
  CHECK_FALSE(five.is_inhibit_shown());
  CHECK_FALSE(five.is_neutral_demanded());
  CHECK(five.system_state() == 0);
  five.cycle(wire::forward_fast, 100);
  CHECK(five.left() > 0);
}

TEST_CASE("one general off neutral among the five starts them over, on either axis", "[SB-01.8][H-02][H-06]") {
  for (const Bytes& deflected :
       {sr_general({543, 512, 0}), sr_general({481, 512, 0}), sr_general({512, 543, 0}), sr_general({512, 481, 0})}) {
    Bench bench = Bench::greeted();
    bench.cycle(wire::at_rest, 4);
    bench.cycle(deflected);
    bench.cycle(wire::at_rest, 4);
    bench.cycle(wire::forward_fast, 50);
    CHECK(bench.is_still());
  }
}

TEST_CASE("real sticks at rest count as neutral", "[SB-00.8][SB-01.8]") {
  for (const SrWords& words : {SrWords{505, 500}, SrWords{525, 515}, SrWords{537, 487}, SrWords{482, 542}}) {
    Bench bench = Bench::greeted();
    bench.cycle(sr_general(words), 50);
    CHECK_FALSE(bench.is_inhibit_shown());
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
  }
}

// ---- what forbids to drive

struct Forbidden {
  const char* name;
  Bytes general;   // full forward at pot 255, with the bit
  unsigned state;  // what is shown while it lasts
};

const Forbidden forbidden[] = {
    {"remote inhibit", sr_general({1022, 514, 255, 0, 0x08, 0}), 1},
    {"charger inhibit", sr_general({1022, 514, 255, 0x08, 0, 0}), 1},
    {"joystick error", sr_general({1022, 514, 255, 0x40, 0, 0}), 7},
    {"local fault", sr_general({1022, 514, 255, 0x10, 0, 0}), 7},
    {"joystick calibration", sr_general({1022, 514, 255, 0, 0x02, 0}), 1},
    {"actuator mode", sr_general({1022, 514, 255, 0, 0, 0x01}), 1},
    {"undefined mode", sr_general({1022, 514, 255, 0, 0, 0x0F}), 1},
};

TEST_CASE("whatever forbids to drive stops the chair from the next millisecond on, and keeps it stopped",
          "[SB-00.4][SB-00.5][SB-00.6][SB-00.7][SB-01.10][H-19][H-02]") {
  for (const Forbidden& one : forbidden) {
    CAPTURE(one.name);
    Bench bench = Bench::driving();
    REQUIRE(bench.left() == 16384);
    bench.hear(one.general);
    const Microseconds begin = bench.now();
    bench.hear(wire::tf);
    bench.run_until(begin + 5000);
    CHECK(bench.left() < 16384);  // H-19: begins within 5 ms
    CHECK(bench.is_inhibit_shown());
    bench.run_until(begin + 17000);
    bool was_still = false;
    int before = bench.left();
    for (int i = 0; i < 87; ++i) {  // 1.75 s
      bench.cycle(one.general);
      REQUIRE(bench.left() <= before);
      before = bench.left();
      was_still = was_still || (bench.is_still() && bench.now() - begin <= 1500000);
    }
    CHECK(was_still);
    CHECK(bench.is_braked());
    CHECK(bench.is_inhibit_shown());
    CHECK(bench.system_state() == one.state);
    CHECK_FALSE(bench.is_driving_shown());

    bench.cycle(wire::forward_fast, 50);  // the bit is gone, the stick still held
    CHECK(bench.is_still());
    CHECK(bench.is_neutral_demanded());
    CHECK(bench.system_state() == 1);
    bench.cycle(wire::at_rest, 4);
    bench.cycle(wire::forward_fast, 20);
    CHECK(bench.is_still());
    bench.cycle(wire::at_rest, 5);
    CHECK_FALSE(bench.is_inhibit_shown());
    bench.cycle(wire::forward_fast, 50);
    CHECK(bench.left() > 0);
    CHECK_FALSE(bench.is_limping());
  }
}

TEST_CASE("charging forbids to drive whatever the programmer does, unless a setting says that it yields to it",
          "[SB-00.5][H-19]") {
  const Bytes charging_at_rest = sr_general({512, 512, 255, 0x08, 0, 0});
  const Bytes charging_forward = sr_general({1022, 512, 255, 0x08, 0, 0});
  const Bytes typed{0x02, 0xC1, 0xBC};  // HHP data: "A"
  for (const bool does_yield : {false, true}) {
    CAPTURE(does_yield);
    spm::Settings settings;
    settings.set(spm::Setting::charging_yields, does_yield ? 1 : 0);
    Bench bench = Bench::ready(Bench(1000, settings));
    bench.cycle(charging_at_rest + typed, 10);
    CHECK(bench.is_inhibit_shown() == !does_yield);
    bench.cycle(charging_forward + typed, 50);
    CHECK((bench.left() > 0) == does_yield);
    if (!does_yield) {
      continue;
    }
    bench.cycle(charging_forward, 49);  // 980 ms after the last character
    CHECK_FALSE(bench.is_inhibit_shown());
    bench.cycle(charging_forward, 3);
    CHECK(bench.is_inhibit_shown());
    bench.cycle(charging_forward, 90);
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
  }
}

TEST_CASE("one general with a forbidding bit is enough, even among good ones", "[H-06][H-19]") {
  for (const Forbidden& one : forbidden) {
    CAPTURE(one.name);
    Bench bench = Bench::driving();
    bench.cycle(one.general);
    bench.cycle(wire::forward_fast, 150);
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
  }
}

TEST_CASE("one general without the bit does not free a chair that is forbidden to drive", "[H-06][SB-01.8]") {
  for (const Forbidden& one : forbidden) {
    CAPTURE(one.name);
    Bench bench = Bench::ready();
    for (int i = 0; i < 50; ++i) {
      bench.cycle(one.general);
      bench.cycle(wire::at_rest);
      REQUIRE(bench.is_inhibit_shown());
    }
    CHECK(bench.is_still());
  }
}

TEST_CASE("during calibration neutral is demanded, and after it until it was seen", "[SB-01.10][SB-01.8]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::calibrating, 10);
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.is_neutral_demanded());
  bench.cycle(wire::at_rest, 3);
  CHECK(bench.is_neutral_demanded());
  bench.cycle(wire::at_rest, 2);
  CHECK_FALSE(bench.is_neutral_demanded());
}

TEST_CASE("joystick error and local fault show the remote's fault and are logged", "[SB-00.6][SB-01.9]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::joystick_error);
  CHECK(bench.system_state() == 7);
  CHECK(bench.has_event(spm::EventCode::joystick_error));
  CHECK_FALSE(bench.is_limping());
  bench.cycle(wire::at_rest, 10);
  CHECK(bench.system_state() == 0);
  bench.cycle(wire::local_fault);
  CHECK(bench.system_state() == 7);
  CHECK(bench.has_event(spm::EventCode::remote_fault));
}

TEST_CASE("a pot error makes the chair limp until power-down", "[SB-00.6][H-07]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::pot_error);
  CHECK(bench.is_limping());
  CHECK(bench.general_bit(0, 5));
  CHECK(bench.system_state() == 7);
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(wire::at_rest, 100);
  CHECK(bench.is_limping());
}

TEST_CASE("with a pot error the middle of the pot's range is used, whatever it reads", "[SB-00.6][H-33]") {
  for (const unsigned pot : {0U, 77U, 255U}) {
    Bench bench = Bench::ready();
    // The stick half way, so that LIMP's 40 percent are no bound: 222 of 445 counts.
    bench.cycle(sr_general({764, 512, pot, 0x20, 0, 0}), 400);
    CAPTURE(pot);
    // 22 percent and half of the remaining 78 are 61 percent.
    CHECK(bench.left() == Approx(0.61 * 222 / 445 * 16384).margin(60));
  }
}

TEST_CASE("a non-critical fault of the remote makes the chair limp while it lasts", "[SB-00.6]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::non_critical_fault, 3);
  CHECK(bench.is_limping());
  CHECK(bench.general_bit(0, 5));
  CHECK(bench.system_state() == 7);
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(sr_general({1022, 512, 255, 0, 0, 0x20}), 400);
  CHECK(bench.left() == Approx(6554).margin(1));
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_limping());
  bench.cycle(wire::at_rest);
  CHECK_FALSE(bench.is_limping());
  bench.cycle(wire::at_rest);  // what ends may be told one answer later
  CHECK(bench.system_state() == 0);
  CHECK_FALSE(bench.general_bit(0, 5));
}

TEST_CASE("one garbled general without the non-critical fault does not end its LIMP, nor four",
          "[SB-00.6][H-06][H-07]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::non_critical_fault, 300);
  for (int i = 0; i < 50; ++i) {
    bench.cycle(wire::forward_fast, i % 2 == 0 ? 4 : 1);
    REQUIRE(bench.is_limping());
    REQUIRE(bench.left() <= 6554);
    bench.cycle(wire::non_critical_fault);
  }
  bench.cycle(wire::forward_fast, 5);
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("a flat battery stops the chair after 2 s, and neutral is needed after it", "[SB-01.9][H-26]") {
  Bench bench = Bench::driving();
  bench.in.battery = base::Millivolts(17900);  // and 0.07 V for what coils and electronics take
  bench.cycle(wire::forward_fast, 99);
  CHECK(bench.left() > 15000);  // low for a second: it has begun to slow down
  CHECK(bench.system_state() == 2);
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(wire::forward_fast, 7);
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.system_state() == 2);
  CHECK(bench.has_event(spm::EventCode::battery_flat));
  bench.cycle(wire::forward_fast, 100);
  CHECK(bench.is_braked());
  bench.in.battery = base::Millivolts(24000);
  bench.cycle(wire::forward_fast, 20);
  CHECK(bench.is_still());
  bench.cycle(wire::at_rest, 6);
  CHECK_FALSE(bench.is_inhibit_shown());
}

TEST_CASE("a dip of the battery shorter than 2 s, or readings that are not real yet, stop nothing", "[H-26]") {
  Bench dip = Bench::driving();
  dip.in.battery = base::Millivolts(15000);
  dip.cycle(wire::forward_fast, 95);
  dip.in.battery = base::Millivolts(24000);
  dip.cycle(wire::forward_fast, 50);
  CHECK_FALSE(dip.is_inhibit_shown());
  CHECK(dip.left() > 15000);
  dip.in.battery = base::Millivolts(18000);  // just enough
  dip.cycle(wire::forward_fast, 700);
  CHECK_FALSE(dip.is_inhibit_shown());
  CHECK(dip.left() == 8192);  // low: half the speed
  Bench blind = Bench::driving();
  blind.in.analog_ready = false;
  blind.in.battery = base::Millivolts(0);
  blind.cycle(wire::forward_fast, 200);
  CHECK(blind.left() == 16384);
}

TEST_CASE("an unexpected reset leaves the chair stopped, limping and logged, and waiting for the handshake",
          "[SB-3.9][H-25]") {
  Bench bench;
  bench.in.start = spm::Start::watchdog;
  spm::Spm module;
  spm::Inputs in;
  in.start = spm::Start::watchdog;
  module.step(in, base::Instant(0));
  CHECK(module.events().newest(0).code == static_cast<std::uint8_t>(spm::EventCode::started));
  CHECK(module.events().newest(0).argument == 1);
  bench.cycle(wire::forward_fast, 20);
  CHECK(bench.turns().empty());
  CHECK(bench.is_braked());
  bench = Bench::ready(std::move(bench));
  CHECK(bench.is_limping());
  CHECK(bench.system_state() == 8);
  bench.cycle(wire::forward_fast, 400);
  CHECK(bench.left() == Approx(6554).margin(1));
}

TEST_CASE("the start says its cause: 0 power on, 1 watchdog, 2 brown-out, 3 external", "[SB-3.9]") {
  const auto started = [](spm::Start start) {
    spm::Spm module;
    spm::Inputs in;
    in.start = start;
    const spm::Outputs& outputs = module.step(in, base::Instant(0));
    REQUIRE(outputs.events.size() == 1);
    CHECK(outputs.events[0].code == 1);
    const int argument = outputs.events[0].argument;
    CHECK(module.step(in, base::Instant(1)).events.empty());
    return std::make_pair(argument, module.faults().is_limping);
  };
  CHECK(started(spm::Start::power_on) == std::make_pair(0, false));
  CHECK(started(spm::Start::watchdog) == std::make_pair(1, true));
  CHECK(started(spm::Start::brown_out) == std::make_pair(2, true));
  CHECK(started(spm::Start::external) == std::make_pair(3, false));
}

TEST_CASE("a self-test that failed keeps the chair where it is, says so, and logs what: 1 flash, 2 RAM", "[H-27]") {
  for (const int what : {1, 2}) {
    Bench bench;
    bench.in.self_test = static_cast<spm::SelfTest>(what);
    bench = Bench::ready(std::move(bench));
    CHECK(bench.is_limping());
    CHECK(bench.is_inhibit_shown());
    CHECK(bench.system_state() == 8);
    bench.cycle(wire::forward_fast, 200);
    CHECK(bench.left() == 0);
    CHECK(bench.is_braked());
    CHECK(bench.argument_of(33) == what);
  }
}

TEST_CASE("a flash that is found wrong while driving stops the chair by its ramp, for good", "[H-27]") {
  Bench bench = Bench::driving();
  bench.in.self_test = spm::SelfTest::flash_later;
  bench.cycle(wire::forward_fast, 2);
  CHECK(bench.left() > 0);
  CHECK(bench.left() < 16384);
  bench.cycle(wire::forward_fast, 200);
  CHECK(bench.left() == 0);
  CHECK(bench.is_braked());
  CHECK(bench.system_state() == 8);
  CHECK(bench.argument_of(33) == 3);
  bench.cycle(wire::at_rest, 20);
  bench.cycle(wire::forward_fast, 100);
  CHECK(bench.is_braked());
}

TEST_CASE("too many restarts keep the chair where it is", "[H-25]") {
  Bench bench;
  bench.in.start = spm::Start::watchdog;
  bench.in.has_restarted_often = true;
  bench = Bench::ready(std::move(bench));
  CHECK(bench.system_state() == 8);
  CHECK(bench.is_inhibit_shown());
  bench.cycle(wire::forward_fast, 200);
  CHECK(bench.is_braked());
  CHECK(bench.argument_of(34) == 0);
}

TEST_CASE("a stack that was too deep stops the chair for good, and is logged once", "[H-22]") {
  Bench bench = Bench::driving();
  bench.in.has_stack_overrun = true;
  bench.cycle(wire::forward_fast, 200);
  CHECK(bench.left() == 0);
  CHECK(bench.is_braked());
  CHECK(bench.system_state() == 8);
  CHECK(bench.count_of(41) == 1);
  CHECK(bench.count_of(24) == 0);
}

TEST_CASE("lost settings make the chair limp, and are logged", "[H-20]") {
  Bench bench;
  bench.in.settings_lost = true;
  bench = Bench::ready(std::move(bench));
  CHECK(bench.is_limping());
  CHECK(bench.system_state() == 8);
  CHECK(bench.has_event(spm::EventCode::settings_lost));
}

// ---- operating modes

TEST_CASE("each mode but drive is echoed in the answer to its own turn and called invalid", "[SB-00.7][SB-3.7][H-17]") {
  for (unsigned mode = 1; mode < 16; ++mode) {
    Bench bench = Bench::ready();
    for (int i = 0; i < 5; ++i) {
      bench.cycle(sr_general({.byte6 = mode}));
      CAPTURE(mode);
      REQUIRE(bench.general_byte(5) == (0x10 | mode));
      REQUIRE(bench.is_inhibit_shown());
    }
    bench.cycle(wire::at_rest);
    CHECK(bench.general_byte(5) == 0);
  }
}

TEST_CASE("the captured request for an actuator is refused by a module without any", "[SB-3.7][SB-00.7]") {
  Bench bench = Bench::ready();
  bench.cycle({0x60, 0x80, 0xB8, 0x80, 0x82, 0x80, 0x84, 0x81, 0xE0}, 50);
  CHECK(bench.general_byte(5) == 0x11);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
}

TEST_CASE("back in drive mode nothing moves until neutral has been seen", "[SB-00.7][SB-01.8][H-17][H-02]") {
  Bench bench = Bench::ready();
  bench.cycle(sr_general({.byte6 = 1}), 10);
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.is_still());
  CHECK(bench.is_neutral_demanded());
  bench.cycle(wire::at_rest, 5);
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.left() > 0);
}

// ---- motion

TEST_CASE("the stick's four directions turn the wheels as they should", "[H-11][SB-00.8]") {
  struct Case {
    unsigned speed, direction;
    int left, right;  // signs
  };
  const Case cases[] = {{1022, 512, 1, 1}, {7, 512, -1, -1},  {512, 1023, 1, -1},
                        {512, 0, -1, 1},   {1023, 700, 1, 1}, {0, 300, -1, -1}};
  for (const Case& one : cases) {
    Bench bench = Bench::ready();
    bench.cycle(sr_general({one.speed, one.direction, 128}), 400);
    CAPTURE(one.speed, one.direction);
    CHECK(bench.left() * one.left > 0);
    CHECK(bench.right() * one.right > 0);
    if (one.direction != 512) {
      CHECK((bench.left() > bench.right()) == (one.direction > 512));
    }
  }
}

TEST_CASE("brakes open first, then torque comes; at rest the torque goes first, then brakes close", "[H-12][H-13]") {
  Bench bench = Bench::ready();
  bench.hear(wire::forward_slow);
  const Microseconds asked = bench.now();
  bench.hear(wire::tf);
  bench.run_until(asked + 3000);
  CHECK_FALSE(bench.is_braked());
  bench.run_until(asked + 20000);
  while (!bench.is_driving_shown()) {
    CHECK(bench.is_still());
    bench.cycle(wire::forward_slow);
    REQUIRE(bench.now() - asked < 200000);
  }
  CHECK(bench.now() - asked >= 100000);  // as real chairs: about 0.1 s

  bench.cycle(wire::forward_slow, 100);
  CHECK(bench.left() == Approx(3604).margin(2));
  while (!bench.is_still()) {
    bench.cycle(wire::at_rest);
  }
  const Microseconds stopped = bench.now();
  while (!bench.is_braked()) {
    REQUIRE(bench.is_driving_shown());
    bench.cycle(wire::at_rest);
  }
  CHECK(bench.now() - stopped == Approx(800000).margin(30000));
  bench.cycle(wire::at_rest);
  CHECK_FALSE(bench.is_driving_shown());
  CHECK_FALSE(bench.outputs().bridge_enabled);
}

TEST_CASE("a stick let go stops the chair at once and without growing", "[H-03]") {
  Bench bench = Bench::driving();
  bench.hear(wire::at_rest);
  int before = bench.left();
  bench.run_ms(2);
  CHECK(bench.left() < before);
  bench.hear(wire::tf);
  bench.run_ms(15);
  before = bench.left();
  int spent = 0;
  while (!bench.is_still()) {
    bench.cycle(wire::at_rest);
    REQUIRE(bench.left() < before);
    before = bench.left();
    REQUIRE(++spent < 110);  // 2.1 s from full speed
  }
}

TEST_CASE("the speedo follows the chair, not the stick", "[SB-01.7]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::forward_fast, 2);
  CHECK(bench.speedo() == 0);
  unsigned before = 0;
  for (int i = 0; i < 400; ++i) {
    bench.cycle(wire::forward_fast);
    REQUIRE(bench.speedo() >= before);
    before = bench.speedo();
  }
  CHECK(before == 31);
  bench.cycle(wire::at_rest, 120);
  CHECK(bench.speedo() == 0);
}

TEST_CASE("one garbled general that looks valid cannot start the chair", "[H-06][H-01]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 50; ++i) {
    bench.cycle(wire::forward_fast);
    bench.cycle(wire::at_rest, 4);
    REQUIRE(bench.is_still());
  }
}

TEST_CASE("the status LED is steady while all is well and flashes otherwise", "[SB-01.9]") {
  Bench bench = Bench::ready();
  CHECK(bench.outputs().status_led);
  bench.cycle(wire::joystick_error, 100);
  bool was_dark = false;
  for (int i = 0; i < 100; ++i) {
    bench.cycle(wire::joystick_error);
    was_dark = was_dark || !bench.outputs().status_led;
  }
  CHECK(was_dark);
}

// H-33 and H-01 are watched by the bench itself, in every step of every test; this one looks for trouble.
TEST_CASE("whatever happens on the bus while driving, the wheels never jump and never go without leave",
          "[H-33][H-01][H-04][H-12][H-13][H-14]") {
  std::uint32_t seed = 1;
  const auto random = [&seed](std::uint32_t below) {
    seed = seed * 1664525U + 1013904223U;
    return (seed >> 8) % below;
  };
  for (int run = 0; run < 12; ++run) {
    Bench bench = Bench::ready();
    for (int i = 0; i < 600; ++i) {
      const unsigned pot = random(256);
      switch (random(14)) {
        case 0:
          bench.cycle(sr_general({random(1024), random(1024), pot, 1U << random(7), 0, 0}));
          break;
        case 1:
          bench.cycle(sr_general({random(1024), random(1024), pot, 0, random(8) << 1, 0}));
          break;
        case 2:
          bench.cycle(corrupted(sr_general({random(1024), random(1024), pot})), static_cast<int>(random(4)));
          break;
        case 3:
          if (random(8) == 0) {
            bench.cycle(wire::sr_power_up);
          }
          break;
        case 4:
          bench.run_ms(random(100));
          break;
        case 5:
          bench.cycle(sr_general({random(1024), random(1024), pot, 0, 0, random(64)}));
          break;
        case 6:
          bench.cycle(wire::at_rest, 10);
          break;
        default:
          bench.cycle(sr_general({random(1024), random(1024), pot}), static_cast<int>(random(30)));
          break;
      }
      if (bench.is_off()) {
        break;
      }
    }
  }
}

}  // namespace
