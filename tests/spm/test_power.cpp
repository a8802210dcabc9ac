// Power button, sleep, power-down and a remote that is gone (section 4).
#include "spm/power.hpp"

#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

// A press that was held for 100 ms and released: power-down is asked for, not yet confirmed.
Bench pressed(Bench bench = Bench::ready()) {
  bench.cycle(wire::button_down, 5);
  bench.cycle(wire::at_rest);
  REQUIRE(bench.is_power_down_asked());
  return bench;
}

// ---- the supply is held

TEST_CASE("the latch is held from the first millisecond on", "[SB-1.2]") {
  Bench bench;
  bench.run_ms(1);
  CHECK(bench.outputs().latch == spm::Latch::hold);
}

TEST_CASE("the latch is held while wake is still asserted", "[SB-1.2][SB-1.3]") {
  Bench bench;
  bench.in.wake = true;
  bench.run_ms(300);
  CHECK(bench.outputs().latch == spm::Latch::hold);
}

// ---- the button

TEST_CASE("power down is asked for when the button is released, not before", "[SB-4.1][SB-01.2][H-16]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::button_down, 100);
  CHECK_FALSE(bench.is_power_down_asked());
  CHECK(bench.is_inhibit_shown());
  bench.cycle(wire::at_rest);
  CHECK(bench.is_power_down_asked());
  CHECK_FALSE(bench.general_bit(2, 3));  // not sleep
  bench.cycle(wire::at_rest, 10);
  CHECK(bench.is_power_down_asked());
  CHECK_FALSE(bench.is_off());
}

TEST_CASE("presses shorter than 50 ms are bounce, longer ones are presses", "[SB-4.1][H-16]") {
  const auto is_taken = [](int generals, Microseconds period) {
    Bench bench = Bench::ready();
    bench.cycle(wire::button_down, generals, period);
    bench.cycle(wire::at_rest, 5);
    return bench.is_power_down_asked();
  };
  CHECK_FALSE(is_taken(1, 20000));
  CHECK_FALSE(is_taken(2, 20000));
  CHECK_FALSE(is_taken(3, 20000));  // seen for 40 ms
  CHECK(is_taken(4, 20000));        // 60 ms
  CHECK_FALSE(is_taken(2, 48000));  // 48 ms
  CHECK(is_taken(2, 51000));        // 51 ms
}

TEST_CASE("bounces do not add up to a press", "[SB-4.1]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 20; ++i) {
    bench.cycle(wire::button_down, 2);
    bench.cycle(wire::at_rest);
  }
  CHECK_FALSE(bench.is_power_down_asked());
  CHECK_FALSE(bench.is_inhibit_shown());
}

TEST_CASE("a button already down at power-up must first be released", "[SB-4.1][H-16]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::button_down, 50);
  CHECK_FALSE(bench.is_power_down_asked());
  bench.cycle(wire::at_rest, 10);
  CHECK_FALSE(bench.is_power_down_asked());
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(wire::button_down, 5);
  bench.cycle(wire::at_rest);
  CHECK(bench.is_power_down_asked());
}

TEST_CASE("the motors stop as soon as the press is accepted, the button still down", "[SB-4.1][H-16]") {
  Bench bench = Bench::driving();
  const Bytes driving_and_pressing = sr_general({1022, 514, 255, 0x04, 0, 0});
  bench.cycle(driving_and_pressing, 3);
  CHECK(bench.left() == 16384);
  bench.cycle(driving_and_pressing);
  CHECK(bench.left() < 16384);
  bench.cycle(driving_and_pressing, 90);
  CHECK(bench.is_braked());
  CHECK_FALSE(bench.is_power_down_asked());
}

TEST_CASE("after power-down was asked for nothing drives any more", "[SB-4.1]") {
  Bench bench = pressed();
  bench.cycle(wire::at_rest, 10);
  bench.cycle(wire::forward_fast, 10);
  CHECK(bench.is_still());
  CHECK(bench.is_inhibit_shown());
}

// ---- the confirmation

TEST_CASE("two confirms in a row release the latch, at rest within 200 ms", "[SB-4.3]") {
  Bench bench = pressed();
  bench.cycle(wire::confirm);
  CHECK_FALSE(bench.is_off());
  bench.hear(wire::confirm);
  bench.run_ms(200);
  CHECK(bench.is_off());
  CHECK(bench.has_event(spm::EventCode::powered_down));
  CHECK(bench.spm().events().newest(0).argument == 0);
}

TEST_CASE("the latch is held while something is being written, 200 ms at most", "[SB-4.3][SB-4.5][H-20]") {
  Bench bench = pressed();
  bench.cycle(wire::confirm);
  bench.hear(wire::confirm);
  bench.in.is_storing = true;
  const Microseconds confirmed = bench.now();
  Bench patient = bench;
  patient.run_until(confirmed + 150000);
  CHECK_FALSE(patient.is_off());
  CHECK(patient.has_event(spm::EventCode::powered_down));  // said before, so that it can be written
  patient.in.is_storing = false;
  patient.run_ms(10);
  CHECK(patient.is_off());
  bench.run_until(confirmed + 165000);
  CHECK_FALSE(bench.is_off());
  bench.run_until(confirmed + 200000);
  CHECK(bench.is_off());
}

TEST_CASE("the power-down is said once, in one step, and the latch goes in a later one", "[SB-4.3]") {
  Bench bench = pressed();
  bench.cycle(wire::confirm);
  bench.hear(wire::confirm);
  int times = 0;
  while (!bench.is_off()) {
    bench.run_us(500);
    for (const faults::Event& event : bench.outputs().events) {
      CHECK(event.code == 6);
      CHECK(event.argument == 0);
      ++times;
      CHECK_FALSE(bench.is_off());
    }
  }
  CHECK(times == 1);
}

TEST_CASE("that the remote is gone makes the latch wait for no writing of its own", "[SB-4.4]") {
  Bench bench = pressed();
  bench.hear(wire::at_rest);
  const Microseconds end = bench.now();
  while (!bench.is_off()) {
    bench.run_us(500);
    REQUIRE((bench.outputs().events.empty() || bench.outputs().events[0].code != 6));
  }
  CHECK(bench.now() - end <= 520000);
  CHECK(bench.has_event(spm::EventCode::powered_down));
}

TEST_CASE("confirms that do not come in a row do not count", "[SB-4.3][H-06][H-16]") {
  Bench bench = pressed();
  for (int i = 0; i < 10; ++i) {
    bench.cycle(wire::confirm);
    bench.cycle(wire::at_rest);
  }
  CHECK_FALSE(bench.is_off());
}

TEST_CASE("a confirm that was not asked for is ignored, and does not count later", "[SB-4.3][H-16]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::confirm, 50);
  CHECK_FALSE(bench.is_off());
  CHECK_FALSE(bench.is_inhibit_shown());
  bench.cycle(sr_general({.byte4 = 0x04, .byte5 = 0x01}), 5);
  bench.cycle(wire::confirm);  // released: asked for from here on
  bench.run_ms(5);
  CHECK_FALSE(bench.is_off());
}

TEST_CASE("a confirm in the very general that releases the button does not count", "[SB-4.3][H-16]") {
  Bench bench = Bench::ready();
  bench.cycle(sr_general({512, 512, 255, 0x04, 0x05}), 6);  // button and confirm
  bench.cycle(wire::confirm);                               // released: the answer asks
  REQUIRE(bench.general_bit(1, 4));
  bench.cycle(wire::confirm);
  CHECK_FALSE(bench.is_off());
  bench.cycle(wire::confirm);
  bench.run_ms(20);
  CHECK(bench.is_off());
}

TEST_CASE("a confirmed power-down while driving first stops, then brakes, then lets go",
          "[SB-4.3][SB-4.5][H-14][H-16]") {
  Bench bench = Bench::driving();
  bench.cycle(sr_general({1022, 514, 255, 0x04, 0, 0}), 4);
  bench.cycle(wire::forward_fast);
  REQUIRE(bench.is_power_down_asked());
  bench.cycle(wire::confirm, 2);
  REQUIRE_FALSE(bench.is_still());
  while (!bench.is_still()) {
    bench.cycle(wire::confirm);
    REQUIRE_FALSE(bench.is_off());
  }
  const Microseconds stopped = bench.now() - 20000;
  while (!bench.is_off()) {
    bench.run_ms(1);
    REQUIRE(bench.now() - stopped <= 200000 + 20000);
  }
  CHECK(bench.is_braked());
}

TEST_CASE("after the confirmation silence is expected: no TRANSIENT, no LIMP, nothing logged", "[SB-2.15][SB-4.3]") {
  Bench bench = Bench::driving();
  bench.cycle(sr_general({1022, 514, 255, 0x04, 0, 0}), 4);
  bench.cycle(wire::forward_fast);
  bench.cycle(wire::confirm, 2);
  bench.run_ms(300);  // the remote has gone to rest while the chair still rolls out
  CHECK_FALSE(bench.is_still());
  CHECK_FALSE(bench.is_transient());
  CHECK_FALSE(bench.is_limping());
  CHECK_FALSE(bench.has_event(spm::EventCode::general_missing));
}

// ---- the remote is gone

TEST_CASE("with power-down asked for and the remote gone, the latch is released after 500 ms", "[SB-4.4]") {
  Bench bench = pressed();
  bench.hear(wire::at_rest);
  const Microseconds end = bench.now();
  bench.hear(wire::tf);
  bench.run_until(end + 480000);
  CHECK_FALSE(bench.is_off());
  bench.run_until(end + 520000);
  CHECK(bench.is_off());
  CHECK(bench.spm().events().newest(0).argument == 1);
}

TEST_CASE("when communication is lost, the latch is released after 5000 ms", "[SB-4.4][H-04]") {
  Bench bench = Bench::ready();
  bench.hear(wire::at_rest);
  const Microseconds end = bench.now();
  bench.hear(wire::tf);
  bench.run_until(end + 4980000);
  CHECK_FALSE(bench.is_off());
  bench.run_until(end + 5020000);
  CHECK(bench.is_off());
}

TEST_CASE("if nobody ever speaks, the latch is released 5000 ms after reset", "[SB-4.4]") {
  Bench bench;
  const Microseconds reset = bench.now();
  bench.run_until(reset + 4980000);
  CHECK_FALSE(bench.is_off());
  bench.run_until(reset + 5020000);
  CHECK(bench.is_off());
}

TEST_CASE("before the handshake only valid SR power-up packets keep the module on", "[SB-4.4]") {
  Bench generals;
  generals.cycle(wire::at_rest, 249);
  CHECK_FALSE(generals.is_off());
  generals.cycle(wire::at_rest, 2);
  CHECK(generals.is_off());

  Bench corrupt;
  corrupt.cycle(corrupted(wire::sr_power_up), 251);
  CHECK(corrupt.is_off());

  Bench others;
  others.cycle(packet_of(2, 1, 0xC1), 251);
  CHECK(others.is_off());

  Bench power_ups;
  power_ups.cycle(wire::sr_power_up, 300);
  CHECK_FALSE(power_ups.is_off());
}

TEST_CASE("in normal operation any valid packet of the remote shows that it is there", "[SB-4.4]") {
  Bench bench = Bench::ready();
  bench.cycle(packet_of(2, 1, 0xC1), 300);  // HHP data, without a general
  CHECK(bench.is_transient());
  CHECK_FALSE(bench.is_off());
  bench.cycle(corrupted(packet_of(2, 1, 0xC1)), 251);
  CHECK(bench.is_off());
}

TEST_CASE("the latch is never released while a wheel may turn", "[SB-4.5][H-14]") {
  // The slowest ramp a setting allows, and a button press with the remote gone for good just after it.
  spm::Settings settings;
  settings.set(spm::Setting::emergency_deceleration, 740);
  Bench bench = Bench::driving(Bench(1000, settings));
  bench.cycle(sr_general({1022, 514, 255, 0x04, 0, 0}), 4);
  bench.hear(wire::forward_fast + wire::tf);
  bench.run_ms(700);
  CHECK_FALSE(bench.is_still());
  CHECK_FALSE(bench.is_off());
  while (!bench.is_off()) {
    bench.run_ms(1);  // the bench watches that wheels and brakes come first
  }
  CHECK(bench.is_braked());
}

// ---- sleep

TEST_CASE("after the sleep timeout without driver activity, sleep and power-down are asked for together", "[SB-4.2]") {
  spm::Settings settings;
  settings.set(spm::Setting::sleep_timeout, 1);
  Bench bench = Bench::ready(Bench(1000, settings));
  bench.cycle(wire::forward_slow);
  bench.cycle(wire::at_rest, 2998);
  CHECK_FALSE(bench.is_power_down_asked());
  CHECK_FALSE(bench.general_bit(2, 3));
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_power_down_asked());
  CHECK(bench.general_bit(2, 3));
  bench.cycle(wire::confirm, 2);
  CHECK(bench.is_off());
}

TEST_CASE("a driver who does something keeps the chair awake", "[SB-4.2]") {
  spm::Settings settings;
  settings.set(spm::Setting::sleep_timeout, 1);
  Bench bench = Bench::ready(Bench(1000, settings));
  for (int i = 0; i < 4; ++i) {
    bench.cycle(wire::at_rest, 2900);
    bench.cycle(i % 2 == 0 ? wire::forward_slow : wire::button_down);
    REQUIRE_FALSE(bench.is_power_down_asked());
  }
}

TEST_CASE("a timeout of 0 never sleeps", "[SB-4.2]") {
  spm::Settings settings;
  settings.set(spm::Setting::sleep_timeout, 0);
  Bench bench = Bench::ready(Bench(1000, settings));
  bench.cycle(wire::at_rest, 50 * 60 * 20);
  CHECK_FALSE(bench.is_power_down_asked());
}

TEST_CASE("by default the chair sleeps after 15 minutes", "[SB-4.2]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::at_rest, 50 * 60 * 15 - 60);
  CHECK_FALSE(bench.general_bit(2, 3));
  bench.cycle(wire::at_rest, 20);
  CHECK(bench.general_bit(2, 3));
}

// ---- awake again

TEST_CASE("a module that is woken before its supply has died begins anew, and holds the latch", "[SB-1.2][SB-3.1]") {
  Bench bench = pressed();
  bench.cycle(wire::confirm, 2);
  bench.run_ms(10);
  REQUIRE(bench.is_off());
  bench.in.wake = true;
  bench.run_ms(300);
  CHECK(bench.outputs().latch == spm::Latch::hold);
  bench.in.wake = false;
  CHECK(bench.spm().phase() == spm::Phase::silent);
  bench = Bench::ready(std::move(bench));
  CHECK_FALSE(bench.is_limping());
  CHECK(bench.spm().inhibits().empty());
}

}  // namespace
