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
    leave.may_drive = leave.may_release = leave.are_coils_on = true;
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
  // The same, and no wheel may change by more than `most` in any millisecond, nor its sign without standing still.
  void pass_smoothly(int milliseconds, int most) {
    for (int i = 0; i < milliseconds; ++i) {
      const int left_before = left();
      const int right_before = right();
      pass(1);
      REQUIRE(std::abs(left() - left_before) <= most);
      REQUIRE(std::abs(right() - right_before) <= most);
      REQUIRE(left() * left_before >= 0);
      REQUIRE(right() * right_before >= 0);
    }
  }
  int left() const { return motion.demand().left.count(); }
  int right() const { return motion.demand().right.count(); }
};

// What both ramps change in a millisecond by default: 2.4 up and 7.9 down forward, 5.7 up and 9.8 down in a turn; the
// gate's own 12 where it brakes a limping chair.
constexpr int both_ramps = 18;

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

TEST_CASE("a cut takes demand and brakes away in one millisecond", "[H-10]") {
  Rig rig;
  rig.stick(1023, 512);
  rig.pass(3000);
  REQUIRE(rig.left() > 6000);
  rig.leave.must_cut = true;
  rig.leave.may_drive = false;
  rig.pass(1);
  CHECK(rig.left() == 0);
  CHECK(rig.right() == 0);
  CHECK_FALSE(rig.motion.are_brakes_released());
  CHECK_FALSE(rig.motion.is_driving());
  CHECK(rig.motion.speedo() == 0);
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

TEST_CASE("a turn does not jump when LIMP begins, ends, or ends too early", "[SB-2.16][H-33]") {
  for (const int limping : {5, 300, 690, 3000}) {
    Rig rig;
    rig.stick(1023, 900);
    rig.pass(9000);
    const int left = rig.left();
    const int right = rig.right();
    rig.leave.is_limping = true;
    rig.pass_smoothly(limping, both_ramps);
    if (limping == 3000) {
      CHECK(rig.left() == Approx(6554).margin(1));
      CHECK(rig.right() == Approx(6554 - 2 * 4612).margin(4));
    }
    rig.leave.is_limping = false;
    rig.pass_smoothly(1, 9);  // 2.4 and 5.7 up: nothing is made up for
    rig.pass_smoothly(9000, both_ramps);
    CHECK(rig.left() == left);
    CHECK(rig.right() == right);
  }
}

TEST_CASE("no wheel jumps when leave goes and comes, a general is late, or the pot fails", "[H-33][SB-2.17][SB-00.6]") {
  Rig rig;
  unsigned seed = 99;
  const auto random = [&seed](unsigned below) {
    seed = seed * 1664525U + 1013904223U;
    return (seed >> 8) % below;
  };
  constexpr int emergency = 28;  // 13.1 for both
  for (int i = 0; i < 3000; ++i) {
    if (random(3) == 0) {
      rig.stick(static_cast<int>(random(1024)), static_cast<int>(random(1024)), static_cast<int>(random(256)));
    }
    rig.leave.may_drive = random(5) != 0;
    rig.leave.is_limping = random(5) == 0;
    rig.leave.general_age = base::Millis(random(6) == 0 ? 67 : 20);
    rig.pass_smoothly(static_cast<int>(random(200)), emergency);
  }
}

TEST_CASE("a stop in a curve keeps the curve, through the gate, and both wheels stand still together",
          "[SB-2.17][H-04]") {
  for (const int direction : {700, 1023, 300, 0}) {
    Rig rig;
    rig.stick(1023, direction);
    rig.pass(9000);
    const double first_left = rig.left();
    const double first_right = rig.right();
    rig.leave.may_drive = false;
    int spent = 0;
    while (rig.left() != 0 || rig.right() != 0) {
      const int left = rig.left();
      const int right = rig.right();
      rig.pass(1);
      ++spent;
      REQUIRE(rig.left() <= left);
      REQUIRE(rig.right() <= right);
      REQUIRE(rig.left() * first_right == Approx(rig.right() * first_left).margin(3 * 16384));
    }
    CHECK(spent <= 1500);
  }
}

TEST_CASE("a general that comes late holds the chair back, and nothing is made up for when it has come",
          "[H-33][SB-2.15]") {
  Rig rig;
  rig.stick(1023, 512);
  rig.pass(3000);
  const int before = rig.left();
  rig.leave.general_age = 67_ms;
  rig.pass(50);
  CHECK(rig.left() == before - 50 * 12);
  rig.leave.general_age = 20_ms;
  rig.pass_smoothly(1000, 3);
}

TEST_CASE("an inner wheel that changes its direction stands still for a millisecond and does not jump after it",
          "[H-33]") {
  Rig rig;
  rig.stick(1023, 512, 0);
  rig.pass(3000);
  REQUIRE(rig.right() == 3604);
  rig.stick(512, 1023, 255);
  rig.pass_smoothly(2000, 14);  // 480 permille a second down and 350 up
  CHECK(rig.right() == -5734);
  rig.stick(1023, 512, 0);
  rig.pass_smoothly(4000, 13);  // 145 up and 600 down
  CHECK(rig.right() == 3604);
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
