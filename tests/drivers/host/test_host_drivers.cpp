#include <catch2/catch.hpp>

#include "drivers/bridge.hpp"
#include "drivers/host/machine.hpp"
#include "drivers/power_latch.hpp"
#include "drivers/self_test.hpp"
#include "drivers/serial.hpp"
#include "drivers/signals.hpp"
#include "drivers/store.hpp"

using drivers::host::Machine;

TEST_CASE("two machines in one process do not know each other") {
  Machine one;
  Machine other;
  drivers::host::select(one);
  drivers::power_latch::hold();
  drivers::store::write(3, 0x42);
  drivers::host::select(other);
  CHECK_FALSE(other.latch_held);
  CHECK(drivers::store::read(3) == 0xFF);
  drivers::host::select(one);
  CHECK(one.latch_held);
  CHECK(drivers::store::read(3) == 0x42);
}

TEST_CASE("a duty beyond full is no duty") {
  Machine machine;
  drivers::host::select(machine);
  drivers::bridge::Motion motion;
  motion.left.duty = 512;
  motion.right.duty = 511;
  drivers::bridge::apply(motion);
  CHECK(machine.motion.left.duty == 0);
  CHECK(machine.motion.right.duty == 511);
}

TEST_CASE("an actuator never extends and retracts at once") {
  Machine machine;
  drivers::host::select(machine);
  drivers::signals::Switched outputs;
  outputs.actuator1_extend = outputs.actuator1_retract = true;
  outputs.actuator2_retract = true;
  drivers::signals::apply(outputs);
  CHECK_FALSE(machine.switched.actuator1_extend);
  CHECK_FALSE(machine.switched.actuator1_retract);
  CHECK(machine.switched.actuator2_retract);
}

TEST_CASE("characters that found no room spoil the next one") {
  Machine machine;
  drivers::host::select(machine);
  for (int i = 0; i < 65; ++i) {
    machine.hear(0x80, false);
  }
  base::HeardByte byte;
  int count = 0;
  while (drivers::serial::take(byte)) {
    CHECK_FALSE(byte.is_spoiled);
    ++count;
  }
  CHECK(count == 63);
  machine.hear(0x81, false);
  REQUIRE(drivers::serial::take(byte));
  CHECK(byte.is_spoiled);
  machine.hear(0x82, false);
  REQUIRE(drivers::serial::take(byte));
  CHECK_FALSE(byte.is_spoiled);
}

TEST_CASE("our own characters are checked and never handed out", "[SB-1.4]") {
  Machine machine;
  drivers::host::select(machine);
  const uint8_t turn[] = {0x05, 0x80, 0xFA, 0x0F};
  drivers::serial::speak(base::Span<const uint8_t>(turn, sizeof turn));
  uint8_t value = 0;
  REQUIRE(machine.sender.next(value));
  machine.hear(0x05, false);
  REQUIRE(machine.sender.next(value));
  CHECK_FALSE(drivers::serial::take_clash());
  machine.hear(0x81, false);
  CHECK(drivers::serial::take_clash());
  CHECK_FALSE(machine.sender.next(value));
  base::HeardByte byte;
  CHECK_FALSE(drivers::serial::take(byte));
}

TEST_CASE("a flash that changes later is found at the end of the round that has seen it", "[H-27]") {
  using drivers::self_test::Result;
  Machine machine;
  drivers::host::select(machine);
  drivers::self_test::start();
  for (int i = 0; i < 100; ++i) {
    drivers::self_test::step();
  }
  machine.wrong_flash.insert({399, 0});  // just passed: this round has seen the old bit
  for (int i = 100; i < 38144 / 4; ++i) {
    drivers::self_test::step();
  }
  CHECK(drivers::self_test::result() == Result::passed);
  for (int i = 0; i < 38144 / 4 - 1; ++i) {
    drivers::self_test::step();
  }
  CHECK(drivers::self_test::result() == Result::passed);
  drivers::self_test::step();
  CHECK(drivers::self_test::result() == Result::flash_later);
  machine.wrong_flash.clear();
  for (int i = 0; i < 2 * 38144 / 4; ++i) {
    drivers::self_test::step();
  }
  CHECK(drivers::self_test::result() == Result::flash_later);  // once is enough
}
