#include "spm/drive.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

namespace {

using namespace spm;

constexpr int full = 16384;

Stick stick(int speed, int direction, int pot = 255) {
  Stick made;
  made.speed = bus::shark::JoystickReading(static_cast<std::uint16_t>(speed));
  made.direction = bus::shark::JoystickReading(static_cast<std::uint16_t>(direction));
  made.pot = bus::shark::PotReading(static_cast<std::uint8_t>(pot));
  return made;
}

DriveProfile profile_with(std::initializer_list<std::pair<Setting, int>> changes) {
  Settings settings;
  for (const auto& [setting, value] : changes) {
    REQUIRE(settings.set(setting, static_cast<std::uint16_t>(value)));
  }
  return make_profile(settings);
}

struct Sides {
  int left;
  int right;
};

Sides targets(const Stick& command, const DriveProfile& profile = make_profile(Settings()), bool is_limping = false) {
  const Wheels wheels = targets_of(command, profile, is_limping);
  return {wheels.left.count(), wheels.right.count()};
}

// The same in real numbers, straight from the requirement: zero in the deadband, linear from its edge to full travel.
double axis(int reading, const Settings& settings) {
  const double beyond = std::abs(reading - 512) - settings[Setting::deadband];
  const double travel = settings[Setting::stick_travel] - settings[Setting::deadband];
  const double share = beyond <= 0 ? 0 : std::min(1.0, beyond / travel);
  return reading < 512 ? -share : share;
}

// ---- rest

TEST_CASE("a stick up to 30 counts off neutral on either axis is at rest", "[SB-00.8][SB-01.8]") {
  const DriveProfile profile = make_profile(Settings());
  for (const int centre : {505, 512, 525, 500, 515}) {  // where real sticks rest
    CHECK(is_at_rest(stick(centre, 512), profile));
    CHECK(is_at_rest(stick(512, centre), profile));
  }
  CHECK(is_at_rest(stick(482, 542), profile));
  CHECK_FALSE(is_at_rest(stick(481, 512), profile));
  CHECK_FALSE(is_at_rest(stick(543, 512), profile));
  CHECK_FALSE(is_at_rest(stick(512, 481), profile));
  CHECK_FALSE(is_at_rest(stick(512, 543), profile));
}

TEST_CASE("at rest there is nothing to do, whatever the pot and LIMP say", "[SB-00.8][H-01]") {
  const DriveProfile profile = make_profile(Settings());
  for (int off = -30; off <= 30; ++off) {
    for (const bool is_limping : {false, true}) {
      CHECK(targets_of(stick(512 + off, 512 - off), profile, is_limping).is_zero());
    }
  }
}

TEST_CASE("motion begins smoothly at the edge of the deadband", "[SB-00.8]") {
  int before = 0;
  for (int off = 31; off < 512; ++off) {
    const int now = targets(stick(512 + off, 512)).left;
    CAPTURE(off);
    REQUIRE(now > before - 1);
    REQUIRE(now - before <= 40);  // 16384 over 445 counts is 37 a count
    before = now;
  }
  CHECK(targets(stick(543, 512)).left > 0);
  CHECK(targets(stick(543, 512)).left < 60);
  CHECK(before == full);
}

TEST_CASE("the stick's whole way is linear in speed, turn and pot", "[SB-00.8]") {
  const Settings settings;
  for (int reading = 0; reading < 1024; reading += 3) {
    for (const int pot : {0, 1, 100, 254, 255}) {
      const double scale = 0.220 + 0.780 * pot / 255;
      const Sides forward = targets(stick(reading, 512, pot));
      CAPTURE(reading, pot);
      REQUIRE(std::abs(forward.left - axis(reading, settings) * scale * full) <= 40);
      REQUIRE(forward.left == forward.right);
      const Sides turn = targets(stick(512, reading, pot));
      REQUIRE(std::abs(turn.left - axis(reading, settings) * 0.350 * scale * full) <= 40);
      REQUIRE(turn.left == -turn.right);
    }
  }
}

// ---- directions

TEST_CASE("forward is forward and right is right, for every pair of stick positions", "[H-11][SB-00.8]") {
  const DriveProfile profile = make_profile(Settings());
  const auto sign = [](int value) { return (value > 0) - (value < 0); };
  unsigned wrong_speed = 0;
  unsigned wrong_turn = 0;
  unsigned too_much = 0;
  for (int speed = 0; speed < 1024; ++speed) {
    // All of the axis near its ends and its middle, every third count between.
    for (int direction = 0; direction < 1024;
         direction += direction < 8 || direction > 1012 || std::abs(direction - 512) < 40 ? 1 : 3) {
      for (const int pot : {0, 255}) {
        const Sides wheels = targets(stick(speed, direction, pot), profile);
        const int wanted_speed = std::abs(speed - 512) <= 30 ? 0 : sign(speed - 512);
        const int wanted_turn = std::abs(direction - 512) <= 30 ? 0 : sign(direction - 512);
        wrong_speed += sign(wheels.left + wheels.right) != wanted_speed ? 1U : 0U;
        wrong_turn += sign(wheels.left - wheels.right) != wanted_turn ? 1U : 0U;
        too_much += std::abs(wheels.left) > full || std::abs(wheels.right) > full ? 1U : 0U;
      }
    }
  }
  CHECK(wrong_speed == 0);
  CHECK(wrong_turn == 0);
  CHECK(too_much == 0);
}

TEST_CASE("the four directions are mirror images of each other", "[H-11]") {
  for (int off = 31; off <= 511; off += 5) {
    for (int turn = 0; turn <= 511; turn += 7) {
      const Sides forward_right = targets(stick(512 + off, 512 + turn));
      const Sides forward_left = targets(stick(512 + off, 512 - turn));
      const Sides back_right = targets(stick(512 - off, 512 + turn));
      CAPTURE(off, turn);
      REQUIRE(forward_right.left == forward_left.right);
      REQUIRE(forward_right.right == forward_left.left);
      REQUIRE(back_right.left == -forward_right.right);
      REQUIRE(back_right.right == -forward_right.left);
    }
  }
}

TEST_CASE("with both axes at their ends the turn is kept and speed gives way", "[H-11]") {
  const Sides corner = targets(stick(1023, 1023));
  CHECK(corner.left == full);
  CHECK(std::abs((corner.left - corner.right) - 0.700 * full) <= 2);
}

TEST_CASE("no stick, pot or LIMP exceeds full demand under any setting", "[H-11][H-21]") {
  for (const int maximum : {100, 1000}) {
    for (const int turn : {50, 350, 1000}) {
      for (const int limp : {50, 500}) {
        for (const int travel : {200, 511}) {
          for (const int deadband : {10, 100}) {
            const DriveProfile profile = profile_with({{Setting::forward_maximum, maximum},
                                                       {Setting::reverse_maximum, maximum},
                                                       {Setting::turn_maximum, turn},
                                                       {Setting::limp_maximum, limp},
                                                       {Setting::stick_travel, travel},
                                                       {Setting::deadband, deadband}});
            for (int speed = 0; speed < 1024; speed += 31) {
              for (int direction = 0; direction < 1024; direction += 31) {
                for (const bool is_limping : {false, true}) {
                  const Sides wheels = targets(stick(speed, direction), profile, is_limping);
                  const int most = is_limping ? limp * full / 1000 + 1 : full;
                  REQUIRE(std::abs(wheels.left) <= most);
                  REQUIRE(std::abs(wheels.right) <= most);
                  if (std::abs(speed - 512) > deadband && std::abs(direction - 512) <= deadband) {
                    REQUIRE((wheels.left > 0) == (speed > 512));
                    REQUIRE(wheels.left == wheels.right);
                  }
                }
              }
            }
          }
        }
      }
    }
  }
}

// ---- maxima, pot, LIMP

TEST_CASE("each maximum bounds its own direction", "[H-21]") {
  const DriveProfile profile =
      profile_with({{Setting::forward_maximum, 500}, {Setting::reverse_maximum, 250}, {Setting::turn_maximum, 100}});
  CHECK(targets(stick(1023, 512), profile).left == 8192);
  CHECK(targets(stick(0, 512), profile).left == -4096);
  CHECK(std::abs(targets(stick(512, 1023), profile).left - 1638) <= 1);
}

TEST_CASE("the pot reaches from 22 percent to all of the maximum and never goes back on its way", "[SB-00.1]") {
  CHECK(std::abs(targets(stick(1023, 512, 0)).left - 3604) <= 1);
  CHECK(targets(stick(1023, 512, 255)).left == full);
  int before = 0;
  for (int pot = 0; pot <= 255; ++pot) {
    const int now = targets(stick(1023, 512, pot)).left;
    REQUIRE(now > before);
    before = now;
  }
}

TEST_CASE("LIMP caps and does not scale: below the cap nothing changes", "[SB-2.16][H-07]") {
  const DriveProfile profile = make_profile(Settings());
  CHECK(targets(stick(1023, 512, 0), profile, true).left == targets(stick(1023, 512, 0), profile, false).left);
  CHECK(std::abs(targets(stick(1023, 512, 255), profile, true).left - 6554) <= 1);
  CHECK(std::abs(targets(stick(0, 512, 255), profile, true).left + 6554) <= 1);
  for (int speed = 0; speed < 1024; speed += 5) {
    for (int direction = 0; direction < 1024; direction += 5) {
      const Sides limping = targets(stick(speed, direction), profile, true);
      REQUIRE(std::abs(limping.left) <= 6555);
      REQUIRE(std::abs(limping.right) <= 6555);
    }
  }
}

TEST_CASE("LIMP's cap is a share of the profile's maximum", "[SB-2.16]") {
  const DriveProfile profile = profile_with({{Setting::forward_maximum, 500}});
  CHECK(targets(stick(1023, 512), profile, true).left == Approx(0.4 * 8192).margin(1));
  const DriveProfile half = profile_with({{Setting::limp_maximum, 200}});
  CHECK(targets(stick(1023, 512), half, true).left == Approx(0.2 * 16384).margin(1));
}

// ---- speedo

TEST_CASE("the speedo goes from 0 at rest to 31 at the profile's maximum", "[SB-01.7]") {
  const DriveProfile profile = make_profile(Settings());
  const auto shown = [&profile](int left, int right) {
    return int(
        speedo_of(Wheels{Demand(static_cast<std::int16_t>(left)), Demand(static_cast<std::int16_t>(right))}, profile));
  };
  CHECK(shown(0, 0) == 0);
  CHECK(shown(full, full) == 31);
  CHECK(shown(-full, -full) == 31);
  CHECK(shown(3604, 3604) == 7);   // full stick at pot 0, as captured
  CHECK(shown(5734, -5734) == 0);  // turning on the spot
  CHECK(shown(8192, 8192) == 16);
}

TEST_CASE("the speedo's maximum is the profile's", "[SB-01.7]") {
  const DriveProfile slow = profile_with({{Setting::forward_maximum, 500}});
  CHECK(int(speedo_of(Wheels{Demand(8192), Demand(8192)}, slow)) == 31);
  CHECK(int(speedo_of(Wheels{Demand(16384), Demand(16384)}, slow)) == 31);
  const DriveProfile slowest = profile_with({{Setting::forward_maximum, 100}});
  CHECK(int(speedo_of(Wheels{Demand(1638), Demand(1638)}, slowest)) == 31);
}

// ---- ramps

struct Ramp {
  Ramps ramps;
  DriveProfile profile = make_profile(Settings());

  int left() const { return ramps.demand().left.count(); }
  int right() const { return ramps.demand().right.count(); }
  // Milliseconds until the left wheel has reached its target.
  int towards(int left_target, int right_target, int most = 20000) {
    const Wheels target{Demand(static_cast<std::int16_t>(left_target)),
                        Demand(static_cast<std::int16_t>(right_target))};
    int spent = 0;
    while ((left() != left_target || right() != right_target) && spent < most) {
      ramps.step(target, profile);
      ++spent;
    }
    return spent;
  }
};

TEST_CASE("acceleration takes the time its setting says, forwards and backwards", "[SB-2.17]") {
  Ramp ramp;
  CHECK(ramp.towards(full, full) == Approx(6897).margin(10));  // 1000 / 145 s
  ramp.ramps.clear();
  CHECK(ramp.towards(-full, -full) == Approx(6897).margin(10));
}

TEST_CASE("deceleration has its own rate, and another one in reverse") {
  Ramp ramp;
  ramp.towards(full, full);
  CHECK(ramp.towards(0, 0) == Approx(2083).margin(5));  // 1000 / 480 s
  ramp.towards(-full, -full);
  CHECK(ramp.towards(0, 0) == Approx(3125).margin(5));  // 1000 / 320 s
}

TEST_CASE("at pot 0 the chair starts and stops as quickly as real ones do", "[SB-00.8]") {
  Ramp ramp;
  CHECK(ramp.towards(3604, 3604) == Approx(1500).margin(50));  // with 0.1 s of brakes: 1.6 to 1.9 s
  CHECK(ramp.towards(0, 0) == Approx(460).margin(100));        // 0.55 s
  ramp.towards(-3604, -3604);
  CHECK(ramp.towards(0, 0) == Approx(690).margin(100));  // 0.75 s
}

TEST_CASE("a reversal passes through zero: it first brakes, then accelerates", "[H-33][H-11]") {
  Ramp ramp;
  ramp.towards(8192, 8192);
  const Wheels back{Demand(-8192), Demand(-8192)};
  int before = ramp.left();
  bool stood_still = false;
  for (int i = 0; i < 6000; ++i) {
    ramp.ramps.step(back, ramp.profile);
    const int now = ramp.left();
    stood_still = stood_still || now == 0;
    REQUIRE(now <= before);
    REQUIRE((now >= 0 || stood_still));
    REQUIRE(before - now <= (now >= 0 ? 9 : 3));  // 480 and 145 permille a second
    before = now;
  }
  CHECK(before == -8192);
}

TEST_CASE("a smaller demand is approached by deceleration, a larger one by acceleration") {
  Ramp ramp;
  ramp.towards(8192, 8192);
  CHECK(ramp.towards(4096, 4096) == Approx(521).margin(3));
  CHECK(ramp.towards(8192, 8192) == Approx(1724).margin(5));
}

TEST_CASE("the wheels of a turn ramp each to its own target and mirror each other") {
  Ramp right;
  Ramp left;
  for (int i = 0; i < 3000; ++i) {
    right.ramps.step(Wheels{Demand(6000), Demand(-2000)}, right.profile);
    left.ramps.step(Wheels{Demand(-2000), Demand(6000)}, left.profile);
    REQUIRE(right.left() == left.right());
    REQUIRE(right.right() == left.left());
  }
  CHECK(right.left() == 6000);
  CHECK(right.right() == -2000);
}

TEST_CASE("the emergency ramp only falls, and from full speed it is at zero within 1500 ms", "[SB-2.17][H-04]") {
  for (const int rate : {740, 800, 2000}) {
    for (const int start : {full, -full, 5000, -77, 1}) {
      Ramp ramp;
      ramp.profile = profile_with({{Setting::emergency_deceleration, rate}, {Setting::acceleration, 2000}});
      ramp.towards(start, -start / 2);
      int spent = 0;
      while (ramp.left() != 0 || ramp.right() != 0) {
        const int left = std::abs(ramp.left());
        const int right = std::abs(ramp.right());
        ramp.ramps.stop(ramp.profile);
        ++spent;
        REQUIRE(std::abs(ramp.left()) <= left);
        REQUIRE(std::abs(ramp.right()) <= right);
        REQUIRE(spent <= 1500);
      }
      CHECK(spent <= std::abs(start) * 1000L / full * 1000 / rate + 2);
      CHECK(spent >= std::abs(start) * 1000L / full * 1000 / rate - 2);
    }
  }
}

TEST_CASE("the slowest ramp still moves every millisecond counted", "[H-21]") {
  Ramp ramp;
  ramp.profile = profile_with({{Setting::acceleration, 20}});
  CHECK(ramp.towards(full, full, 60000) == Approx(50000).margin(200));
}

TEST_CASE("cleared ramps are at rest") {
  Ramp ramp;
  ramp.towards(full, -full);
  ramp.ramps.clear();
  CHECK(ramp.ramps.demand().is_zero());
}

}  // namespace
