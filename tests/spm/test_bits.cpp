// What the module does with each bit that it hears, and when it sets each bit that it says: type, data byte and bits
// are the tag, [01.3.6], as in docs/bus.md. Packets are literals; a bit is named by the byte that differs from a packet
// without it. Bits that other tests show at length carry their tag there.
#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

// ---- type 00: joystick and pot

const Bytes forward_at_pot_254{0x60, 0xFF, 0xC0, 0xFF, 0xB2, 0x80, 0x80, 0x80, 0xAF};
const Bytes right_forward{0x60, 0xFF, 0xFF, 0xFF, 0xF0, 0x80, 0x80, 0x80, 0xB2};  // 1022, and 1016 to the right
const Bytes left_forward{0x60, 0xFF, 0x80, 0xFF, 0xF7, 0x80, 0x80, 0x80, 0xAA};   // 1022, and 7

// Whether a stick that rests there counts as neutral; the deadband ends 30 counts off 512.
bool is_neutral(const Bytes& general) {
  Bench bench = Bench::greeted();
  bench.cycle(general, 10);
  return !bench.is_neutral_demanded();
}

TEST_CASE("the speed axis drives, its upper seven bits and its lower three", "[SB-00.1][00.0.6-0][00.3.5-3]") {
  Bench forward = Bench::ready();
  forward.cycle(wire::forward_fast, 100);
  CHECK(forward.left() > 0);
  CHECK(forward.right() > 0);
  Bench reverse = Bench::ready();
  reverse.cycle(wire::reverse_fast, 100);
  CHECK(reverse.left() < 0);
  CHECK(reverse.right() < 0);
  // 542 is 67 * 8 + 6 and still neutral, 543 is 67 * 8 + 7.
  CHECK(is_neutral({0x60, 0xC3, 0xC0, 0x80, 0xB0, 0x80, 0x80, 0x80, 0xEC}));
  CHECK_FALSE(is_neutral({0x60, 0xC3, 0xC0, 0x80, 0xB8, 0x80, 0x80, 0x80, 0xE4}));
}

TEST_CASE("the direction axis steers, its upper seven bits and its lower three", "[SB-00.1][00.1.6-0][00.3.2-0]") {
  Bench right = Bench::ready();
  right.cycle(right_forward, 100);
  CHECK(right.left() > right.right());
  Bench left = Bench::ready();
  left.cycle(left_forward, 100);
  CHECK(left.left() < left.right());
  CHECK(is_neutral({0x60, 0xC0, 0xC3, 0x80, 0x86, 0x80, 0x80, 0x80, 0x96}));
  CHECK_FALSE(is_neutral({0x60, 0xC0, 0xC3, 0x80, 0x87, 0x80, 0x80, 0x80, 0x95}));
}

TEST_CASE("the speed pot sets how fast, its upper seven bits and its lowest", "[SB-00.1][00.2.6-0][00.3.6]") {
  const auto speed_of = [](const Bytes& general) {
    Bench bench = Bench::ready();
    bench.cycle(general, 400);
    return bench.left();
  };
  CHECK(speed_of(wire::forward_fast) == 16384);
  CHECK(speed_of(wire::forward_slow) == Approx(0.22 * 16384).margin(5));
  // One count of the pot is a 255th of the 78 percent above its floor.
  CHECK(speed_of(forward_at_pot_254) == Approx((1 - 0.78 / 255) * 16384).margin(10));
}

// ---- type 00: what stops, slows or ends

// Full forward at pot 255 with one bit.
const Bytes forward_joystick_error{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0xC0, 0x80, 0x80, 0xAF};
const Bytes forward_pot_error{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0xA0, 0x80, 0x80, 0xCF};
const Bytes forward_local_fault{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x90, 0x80, 0x80, 0xDF};
const Bytes forward_charging{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x88, 0x80, 0x80, 0xE7};
const Bytes forward_inhibited{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x88, 0x80, 0xE7};
const Bytes forward_calibrating{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x82, 0x80, 0xED};
const Bytes forward_limping{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x80, 0xA0, 0xCF};
const Bytes forward_mode_9{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x80, 0x89, 0xE6};

// At full speed the bit comes: inhibit is told at once, and two seconds later the chair stands with its brakes engaged.
void check_that_it_stops(const Bytes& general, unsigned state) {
  Bench bench = Bench::driving();
  REQUIRE(bench.left() == 16384);
  bench.cycle(general);
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.left() < 16384);
  bench.cycle(general, 120);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  CHECK(bench.system_state() == state);
}

TEST_CASE("joystick error stops", "[SB-00.6][H-19][00.4.6]") {
  check_that_it_stops(forward_joystick_error, 7);
}
TEST_CASE("local fault stops", "[SB-00.6][H-19][00.4.4]") {
  check_that_it_stops(forward_local_fault, 7);
}
TEST_CASE("charger inhibit stops", "[SB-00.5][H-19][00.4.3]") {
  check_that_it_stops(forward_charging, 1);
}
TEST_CASE("remote inhibit stops", "[SB-00.4][H-19][00.5.3]") {
  check_that_it_stops(forward_inhibited, 1);
}
TEST_CASE("calibration that goes on stops", "[SB-01.10][H-19][00.5.1]") {
  check_that_it_stops(forward_calibrating, 1);
}

// At full speed the bit comes: it drives on at 40 percent, and says that it is slow.
void check_that_it_limps(const Bytes& general) {
  Bench bench = Bench::driving();
  bench.cycle(general, 200);
  CHECK(bench.left() == Approx(0.4 * 16384).margin(1));
  CHECK(bench.general_byte(0) >> 5 == 0x1);
  CHECK(bench.system_state() == 7);
  CHECK_FALSE(bench.is_inhibit_shown());
}

TEST_CASE("pot error slows down", "[SB-00.6][SB-2.16][00.4.5]") {
  check_that_it_limps(forward_pot_error);
}
TEST_CASE("a non-critical fault slows down", "[SB-00.6][SB-2.16][00.6.5]") {
  check_that_it_limps(forward_limping);
}

TEST_CASE("the power switch, let go, asks for power-down; the confirm brings it",
          "[SB-4.1][SB-4.3][00.4.2][00.5.0][01.1.4]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::confirm, 5);  // nobody asked
  CHECK_FALSE(bench.is_off());
  bench.cycle(wire::button_down, 5);
  CHECK(bench.general_byte(1) == 0x40);
  bench.cycle(wire::at_rest);
  CHECK(bench.general_byte(1) == 0x50);
  bench.cycle(wire::confirm, 2);
  bench.run_ms(200);
  CHECK(bench.is_off());
}

TEST_CASE("the horn switch sounds the horn", "[SB-01.3][00.4.1][01.2.0]") {
  Bench bench = Bench::ready();
  bench.cycle({0x60, 0xC0, 0xC0, 0x80, 0x80, 0x82, 0x80, 0x80, 0x9D});
  CHECK(bench.general_byte(2) == 0x41);
  bench.cycle(wire::at_rest);
  CHECK(bench.general_byte(2) == 0x40);
}

TEST_CASE("the programmer's data goes out only while the remote has room for it", "[SB-03.1][00.5.2]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::at_rest + Bytes{0x02, 0xC1, 0xBC});  // "A" was typed
  bench.cycle(wire::at_rest, 2);
  CHECK(bench.last_turn().size() == 10);
  bench.cycle({0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x84, 0x80, 0x9B});
  const Bytes& turn = bench.last_turn();
  CHECK(Bytes(turn.begin() + 9, turn.end()) == Bytes{0x03, 0xC1, 0xBB, 0x0F});
}

TEST_CASE("a mode that nobody knows is told back as invalid, and nothing moves",
          "[SB-00.7][H-17][00.6.3-0][01.5.4][01.5.3-0]") {
  Bench bench = Bench::ready();
  bench.cycle(forward_mode_9, 100);
  CHECK(bench.general_byte(5) == 0x19);
  CHECK(bench.is_inhibit_shown());
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  bench.cycle(wire::at_rest);
  CHECK(bench.general_byte(5) == 0x00);
}

// ---- type 01

TEST_CASE("the gauge is a number of five bits, 18 at most", "[SB-01.1][01.0.4-0]") {
  const auto gauge_at = [](std::uint16_t millivolts) {
    Bench bench;
    bench.in.battery = base::Millivolts(millivolts);
    bench.cycle(wire::sr_power_up);
    bench.cycle(wire::at_rest, 100);
    return bench.general_byte(0);
  };
  CHECK(gauge_at(22400) == 0);
  CHECK(gauge_at(23900) == 9);
  CHECK(gauge_at(25400) == 18);
  CHECK(gauge_at(29000) == 18);
}

TEST_CASE("a lost link is told as inhibit, slowdown and state 09; what is left of it is slowdown and 09",
          "[SB-2.16][SB-01.9][01.0.5][01.1.6][01.1.3-0]") {
  Bench bench = Bench::ready();
  CHECK(bench.general_byte(0) >> 5 == 0x0);
  CHECK(bench.general_byte(1) == 0x00);
  bench.run_ms(100);
  bench.cycle(wire::at_rest);
  CHECK(bench.general_byte(0) >> 5 == 0x1);
  CHECK(bench.general_byte(1) == 0x49);
  bench.cycle(wire::at_rest, 10);
  CHECK(bench.general_byte(0) >> 5 == 0x1);
  CHECK(bench.general_byte(1) == 0x09);
}

TEST_CASE("lock mode enable follows its setting", "[SB-01.3][01.2.6]") {
  for (const bool is_enabled : {false, true}) {
    spm::Settings settings;
    settings.set(spm::Setting::lock_mode_enable, is_enabled ? 1 : 0);
    Bench bench = Bench::ready(Bench(1000, settings));
    CHECK(bench.general_byte(2) == (is_enabled ? 0x40U : 0x00U));
  }
}

TEST_CASE("out of neutral at power-up is told until the stick has rested for five generals",
          "[SB-01.8][H-02][01.2.5]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::forward_fast, 10);
  CHECK(bench.general_byte(2) == 0x60);
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.general_byte(2) == 0x60);
  bench.cycle(wire::at_rest);
  CHECK(bench.general_byte(2) == 0x40);
}

TEST_CASE("sleep is asked for together with power-down", "[SB-4.2][01.2.3]") {
  spm::Settings settings;
  settings.set(spm::Setting::sleep_timeout, 1);
  Bench bench = Bench::ready(Bench(1000, settings));
  bench.cycle(wire::at_rest, 2940);
  CHECK(bench.general_byte(1) == 0x00);
  CHECK(bench.general_byte(2) == 0x40);
  bench.cycle(wire::at_rest, 100);
  CHECK(bench.general_byte(1) == 0x50);
  CHECK(bench.general_byte(2) == 0x48);
}

TEST_CASE("it says that it drives until the brakes are engaged, and how fast", "[SB-01.4][SB-01.7][01.3.5][01.6.4-0]") {
  Bench bench = Bench::ready();
  CHECK(bench.general_byte(3) == 0x00);
  bench.cycle(wire::forward_fast, 400);
  CHECK(bench.general_byte(3) == 0x20);
  CHECK(bench.general_byte(6) == 31);
  bench.cycle(wire::at_rest, 120);
  CHECK(bench.is_still());
  CHECK_FALSE(bench.is_braked());
  CHECK(bench.general_byte(3) == 0x20);
  CHECK(bench.general_byte(6) == 0);
  bench.cycle(wire::at_rest, 40);
  CHECK(bench.is_braked());
  CHECK(bench.general_byte(3) == 0x00);
}

// ---- type 04

TEST_CASE("who the remote is, and what it can do, is kept from its power-up packet",
          "[SB-04.1][SB-04.2][04.0.6-0][04.1.6-0][04.2.3-0][04.3.6-0][04.4.6-0][04.5.6-0][04.6.6-0][04.7.2][04.7.1]"
          "[04.7.0]") {
  // Type 5, 2019-12, serial 85 * 16384 + 42 * 128 + 99, version 3.1; pot, actuators, lighting.
  const Bytes all_it_can{0x74, 0x85, 0x93, 0x8C, 0xD5, 0xAA, 0xE3, 0xB1, 0x87, 0xCD};
  const Bytes pot{0x74, 0x85, 0x93, 0x8C, 0xD5, 0xAA, 0xE3, 0xB1, 0x84, 0xD0};
  const Bytes actuators{0x74, 0x85, 0x93, 0x8C, 0xD5, 0xAA, 0xE3, 0xB1, 0x82, 0xD2};
  const Bytes lighting{0x74, 0x85, 0x93, 0x8C, 0xD5, 0xAA, 0xE3, 0xB1, 0x81, 0xD3};
  Bench bench;
  bench.cycle(all_it_can);
  CHECK(bench.spm().remote().remote_type == 5);
  CHECK(bench.spm().remote().year == 19);
  CHECK(bench.spm().remote().month == 12);
  CHECK(bench.spm().remote().serial == 1398115);
  CHECK(bench.spm().remote().version == 0x31);
  CHECK(bench.spm().remote().has_analog_pot);
  CHECK(bench.spm().remote().supports_actuators);
  CHECK(bench.spm().remote().supports_lighting);
  const auto can = [&bench](const Bytes& packet) {
    bench.cycle(packet);
    const bus::shark::SrPowerUp& remote = bench.spm().remote();
    return (remote.has_analog_pot ? 4 : 0) + (remote.supports_actuators ? 2 : 0) + (remote.supports_lighting ? 1 : 0);
  };
  CHECK(can(pot) == 4);
  CHECK(can(actuators) == 2);
  CHECK(can(lighting) == 1);
}

// ---- type 06

TEST_CASE("what a joystick's calibration has seen is kept bit by bit",
          "[SB-06.1][06.0.5][06.0.4][06.0.3][06.0.2][06.0.1][06.0.0]") {
  const auto seen_after = [](const Bytes& progress) {
    Bench bench = Bench::ready();
    bench.cycle(wire::calibrating + progress);
    const bus::shark::JoystickCalibration& seen = bench.spm().remote_calibration();
    return (seen.second_pass ? 0x20 : 0) + (seen.neutral_seen ? 0x10 : 0) + (seen.forward_seen ? 0x08 : 0) +
           (seen.reverse_seen ? 0x04 : 0) + (seen.left_seen ? 0x02 : 0) + (seen.right_seen ? 0x01 : 0);
  };
  CHECK(seen_after({0x06, 0x80, 0xF9}) == 0x00);
  CHECK(seen_after({0x06, 0xA0, 0xD9}) == 0x20);
  CHECK(seen_after({0x06, 0x90, 0xE9}) == 0x10);
  CHECK(seen_after({0x06, 0x88, 0xF1}) == 0x08);
  CHECK(seen_after({0x06, 0x84, 0xF5}) == 0x04);
  CHECK(seen_after({0x06, 0x82, 0xF7}) == 0x02);
  CHECK(seen_after({0x06, 0x81, 0xF8}) == 0x01);
}

}  // namespace
