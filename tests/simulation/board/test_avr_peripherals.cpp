#include "tests/simulation/board/bench.hpp"

namespace simulation {
namespace {

constexpr std::uint8_t erased = 0xFF;

std::vector<std::uint8_t> store_with(std::uint8_t choice, std::size_t address, std::uint8_t value) {
  std::vector<std::uint8_t> contents(address + 1, erased);
  contents[0] = choice;
  contents[address] = value;
  return contents;
}

}  // namespace

TEST_CASE("writing two bytes to the EEPROM takes 6.8 ms") {
  Bench bench("store", {0});
  bench.start().run(20ms);
  REQUIRE(bench.byte("is_done") == 1);
  CHECK(bench.byte("was_busy") == 1);
  CHECK(bench.word("elapsed_us") >= 6800);  // 27,200 cycles each
  CHECK(bench.word("elapsed_us") <= 6810);
  CHECK(bench.board->eeprom()[10] == 0xA5);
  CHECK(bench.board->eeprom()[11] == 0x5A);
  CHECK(bench.board->statistics().complaints.empty());
}

TEST_CASE("a write without erasing takes 1.8 ms and can only clear bits") {
  Bench bench("store", store_with(1, 20, 0xF0));
  bench.start().run(20ms);
  CHECK(bench.board->eeprom()[20] == 0x30);
  CHECK(bench.word("elapsed_us") >= 1800);
  CHECK(bench.word("elapsed_us") <= 1820);
}

TEST_CASE("the byte that is being written is known, and a supply that fails may leave anything in it") {
  Bench bench("store", store_with(3, 40, 0x77));
  CHECK_FALSE(bench.board->eeprom_write().has_value());
  bench.start().run(1ms);
  const auto write = bench.board->eeprom_write();
  REQUIRE(write.has_value());
  CHECK(int(write->address) == 40);
  CHECK(int(write->before) == 0x77);
  CHECK(int(write->after) == 0x11);
  bench.board->cut_power(0x5B, bench.now);
  CHECK_FALSE(bench.board->is_powered());
  CHECK_FALSE(bench.board->eeprom_write().has_value());
  CHECK(bench.board->eeprom()[40] == 0x5B);
}

TEST_CASE("the EEPROM asks by interrupt whenever it is ready") {
  Bench bench("store", {2});
  bench.start().run(10ms);
  CHECK(bench.byte("is_done") == 0);
  bench.run(1ms);
  CHECK(bench.byte("is_done") == 1);
  CHECK(bench.board->eeprom()[30] == 0x70);
  CHECK(bench.board->eeprom()[32] == 0x72);
}

TEST_CASE("a supply that fails during an EEPROM write leaves the old byte or an erased one") {
  Bench bench("store", store_with(3, 40, 0x77));
  bench.start().run(1ms);
  REQUIRE(bench.byte("is_done") == 1);
  SECTION("before half-time: the old one") {
    bench.board->power(false, bench.now);
    bench.board->set_eeprom(store_with(1, 40, 0x77));
    CHECK(bench.start().run(10ms).board->eeprom()[40] == 0x77);
  }
  SECTION("after half-time: an erased one") {
    bench.run(1500us).board->power(false, bench.now);
    CHECK(bench.run(10ms).board->eeprom()[40] == erased);
  }
  SECTION("afterwards: the new one") {
    bench.run(3ms).board->power(false, bench.now);
    CHECK(bench.board->eeprom()[40] == 0x11);
  }
  SECTION("and a mere reset does not stop the write") {
    bench.board->reset(ResetKind::external, bench.now);
    bench.board->set_eeprom(store_with(0, 40, 0x77));
    CHECK(bench.run(3ms).board->eeprom()[40] == 0x11);
  }
}

TEST_CASE("a conversion takes channel and voltage of its start") {
  Bench bench("analog");
  bench.surroundings.analog_volts = {0, 1.0, 2.5, 0, 0, 0, 0, 0};
  bench.board->surround(bench.surroundings);
  bench.start().run(5ms);
  REQUIRE(bench.byte("is_done") == 1);
  CHECK(bench.word("first") == 204);      // 1.0 V of 5 V
  CHECK(bench.word("too_early") == 204);  // the old result, until the new one is there
  CHECK(bench.word("second") == 512);     // 2.5 V
  CHECK(bench.word("left_high") == 128);
  CHECK(bench.word("duration") >= 832);  // 13 cycles of 125 kHz
  CHECK(bench.word("duration") <= 860);
  CHECK(bench.byte("flag_before") == 0x10);
  CHECK(bench.byte("flag_after") == 0);
  CHECK(bench.board->statistics().complaints.empty());
}

TEST_CASE("the ADC reads 1023 at the top of its range and above") {
  Bench bench("analog");
  bench.surroundings.analog_volts[1] = 5.0;
  bench.surroundings.analog_volts[2] = -1.0;
  bench.board->surround(bench.surroundings);
  bench.start().run(5ms);
  CHECK(bench.word("first") == 1023);
  CHECK(bench.word("second") == 0);
}

TEST_CASE("outputs follow port and direction") {
  Bench bench("pins", {0b10101010, 0b01000001, 0b01000000, 0b11111010, 0b11011110, 0b11000000, 0});
  bench.start().run(50ms);
  Pins expected;
  expected.status_led = true;         // PB1
  expected.actuator1_extend = true;   // PB3
  expected.motor_relay = true;        // PB5
  expected.actuator2_retract = true;  // PB7
  expected.power_latch = true;        // PC6; PC0 is high but an input: the pull-down wins
  expected.left_forward = true;       // PD6
  CHECK(bench.board->pins() == expected);
  bench.board->power(false, bench.now);
  CHECK(bench.board->pins() == Pins{});
}

TEST_CASE("inputs with pull-ups read what the chair does, however often the port is written") {
  constexpr unsigned dci = 0x01;
  constexpr unsigned strap = 0x20;
  Bench bench("pins", {0x01, 0x20, 0, 0x02, 0, 0, 0});
  bench.surroundings.lighting_fitted = false;
  bench.board->surround(bench.surroundings);
  bench.start().run(50ms);
  CHECK((bench.byte("seen_b") & dci) != 0);
  CHECK((bench.byte("seen_c") & strap) != 0);
  CHECK((bench.byte("seen_d") & 0x05U) == 0x05);  // idle receive lines
  bench.surroundings.dci_slowdown = true;
  bench.surroundings.lighting_fitted = true;
  bench.board->surround(bench.surroundings);
  bench.run(1ms);
  CHECK((bench.byte("seen_b") & dci) == 0);
  CHECK((bench.byte("seen_c") & strap) == 0);
  bench.board->reset(ResetKind::external, bench.now);
  bench.run(50ms);
  CHECK((bench.byte("seen_b") & dci) == 0);
  CHECK((bench.byte("seen_c") & strap) == 0);
  bench.surroundings.dci_slowdown = false;
  bench.board->surround(bench.surroundings);
  bench.run(1ms);
  CHECK((bench.byte("seen_b") & dci) != 0);
}

TEST_CASE("an open input without its pull-up does not read as high") {
  Bench bench("pins", {0, 0, 0, 0, 0, 0, 0});
  bench.start().run(50ms);
  CHECK((bench.byte("seen_b") & 0x01U) == 0);
}

TEST_CASE("toggling one pin through PINx leaves the others alone") {
  Bench bench("pins", {0b00101000, 0, 0, 0b00111010, 0, 0, 1});
  bench.start().run(50ms);
  bool was_on = false;
  bool was_off = false;
  for (int i = 0; i < 50; ++i) {
    const Pins pins = bench.run(7us).board->pins();
    CHECK(pins.motor_relay);
    CHECK(pins.actuator1_extend);
    CHECK_FALSE(pins.actuator1_retract);
    (pins.status_led ? was_on : was_off) = true;
  }
  CHECK(was_on);
  CHECK(was_off);
}

TEST_CASE("the duty is what the motor gets") {
  struct Row {
    std::uint8_t choice;
    std::uint16_t left;
    std::uint16_t right;
  };
  const auto row = GENERATE(Row{0, 300, 100}, Row{1, 0, 0}, Row{2, 511, 0}, Row{3, 0, 0}, Row{4, 211, 411},
                            Row{5, 300, 100});  // half of a new compare value is no value yet
  CAPTURE(int{row.choice});
  Bench bench("pwm", {row.choice});
  bench.start().run(5ms);
  CHECK(bench.board->pins().left_duty == row.left);
  CHECK(bench.board->pins().right_duty == row.right);
  CHECK(bench.board->statistics().complaints.empty());
}

TEST_CASE("a timer stays off after a reset until its mode is set anew") {
  Bench bench("pwm", {0});
  bench.start().run(5ms);
  bench.board->set_eeprom({6});
  bench.board->reset(ResetKind::external, bench.now);
  bench.run(5ms);
  CHECK(bench.board->ram(0x36) == 0);  // TIFR1: nothing has been counted
}

}  // namespace simulation
