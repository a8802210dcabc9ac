#include "spm/motion.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

namespace {

using namespace spm;
using namespace base;

struct Rig {
  Motion motion;
  Motion::Leave leave;
  std::uint32_t now = 0;

  explicit Rig(const Settings& settings = Settings()) {
    motion.configure(settings);
    leave.may_drive = true;
    leave.is_limping = false;
    leave.general_age = 20_ms;
  }
  void stick(int speed, int direction, int pot = 255) {
    motion.command(Stick{bus::shark::JoystickReading(static_cast<std::uint16_t>(speed)),
                         bus::shark::JoystickReading(static_cast<std::uint16_t>(direction)),
                         bus::shark::PotReading(static_cast<std::uint8_t>(pot))});
  }
  void pass(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      motion.step(leave, Instant(++now));
      REQUIRE((motion.are_brakes_released() || motion.demand().is_zero()));
    }
  }
  int left() const { return motion.demand().left.count(); }
};

TEST_CASE("a stick moves the wheels once the brakes are open, and only with leave", "[H-12][H-19]") {
  Rig rig;
  rig.stick(1023, 512);
  rig.leave.may_drive = false;
  rig.pass(1000);
  CHECK(rig.left() == 0);
  CHECK_FALSE(rig.motion.are_brakes_released());
  rig.leave.may_drive = true;
  rig.pass(100);
  CHECK(rig.motion.are_brakes_released());
  CHECK_FALSE(rig.motion.is_driving());
  CHECK(rig.left() == 0);
  rig.pass(20);
  CHECK(rig.motion.is_driving());
  CHECK(rig.left() > 0);
}

TEST_CASE("the time a brake needs to open is its setting", "[H-13]") {
  Settings settings;
  settings.set(Setting::brake_release_time, 300);
  Rig rig(settings);
  rig.stick(1023, 512);
  rig.pass(300);
  CHECK_FALSE(rig.motion.is_driving());
  rig.pass(2);
  CHECK(rig.motion.is_driving());
}

TEST_CASE("without leave a wheel stops at the emergency rate, with leave at its own", "[SB-2.17]") {
  Rig wished;
  wished.stick(1023, 512);
  wished.pass(3000);
  Rig forced = wished;
  const int start = wished.left();
  wished.stick(512, 512);
  forced.leave.may_drive = false;
  wished.pass(100);
  forced.pass(100);
  CHECK(start - wished.left() == Approx(0.1 * 0.480 * 16384).margin(10));
  CHECK(start - forced.left() == Approx(0.1 * 0.800 * 16384).margin(10));
}

TEST_CASE("an old general drives nothing even if nobody else objects", "[SB-2.15][H-01]") {
  Rig rig;
  rig.leave.general_age = 67_ms;
  rig.stick(1023, 512);
  rig.pass(1000);
  CHECK(rig.left() == 0);
}

TEST_CASE("a chair that begins to limp slows down to the cap at its own deceleration", "[SB-2.16][H-33]") {
  Rig rig;
  rig.stick(1023, 512);
  rig.pass(8000);
  REQUIRE(rig.left() == 16384);
  rig.leave.is_limping = true;
  int before = rig.left();
  for (int i = 0; i < 2000; ++i) {
    rig.pass(1);
    REQUIRE(rig.left() <= before);
    REQUIRE(before - rig.left() <= 14);
    before = rig.left();
  }
  CHECK(before == Approx(6554).margin(1));
  rig.leave.is_limping = false;
  rig.pass(8000);
  CHECK(rig.left() == 16384);
}

TEST_CASE("ramps begin at rest after the brakes have closed", "[H-33]") {
  Rig rig;
  rig.stick(1023, 512);
  rig.pass(3000);
  rig.leave.may_drive = false;
  rig.pass(3000);
  CHECK_FALSE(rig.motion.are_brakes_released());
  rig.leave.may_drive = true;
  rig.pass(102);
  CHECK(rig.left() <= 6);
}

TEST_CASE("rest is what the settings' deadband says", "[SB-00.8]") {
  Settings settings;
  settings.set(Setting::deadband, 60);
  Rig rig(settings);
  rig.stick(572, 452);
  CHECK(rig.motion.is_stick_at_rest());
  rig.stick(573, 512);
  CHECK_FALSE(rig.motion.is_stick_at_rest());
}

}  // namespace
