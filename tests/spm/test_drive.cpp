#include "spm/drive.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>

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
  const Wheels wheels = mix(command_of(command, profile, is_limping));
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
      CHECK(command_of(stick(512 + off, 512 - off), profile, is_limping).is_zero());
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

Command command(int forward, int turn) {
  return Command{static_cast<std::int16_t>(forward), static_cast<std::int16_t>(turn)};
}

struct Ramp {
  Ramps ramps;
  DriveProfile profile = make_profile(Settings());

  explicit Ramp(std::initializer_list<std::pair<Setting, int>> changes = {}) : profile(profile_with(changes)) {}

  int left() const { return ramps.demand().left.count(); }
  int right() const { return ramps.demand().right.count(); }
  int forward() const { return (left() + right()) / 2; }
  int turn() const { return (left() - right()) / 2; }

  void run(int wanted_forward, int wanted_turn, int milliseconds) {
    ramps.aim_at(command(wanted_forward, wanted_turn));
    for (int i = 0; i < milliseconds; ++i) {
      ramps.step(profile);
    }
  }
  void stop(int milliseconds = 1) {
    for (int i = 0; i < milliseconds; ++i) {
      ramps.stop(profile);
    }
  }
  // Milliseconds until the command has been reached.
  int towards(int wanted_forward, int wanted_turn, int most = 60000) {
    int spent = 0;
    while ((forward() != wanted_forward || turn() != wanted_turn) && spent < most) {
      run(wanted_forward, wanted_turn, 1);
      ++spent;
    }
    return spent;
  }
};

TEST_CASE("acceleration takes the time its setting says, forwards and backwards", "[SB-2.17]") {
  Ramp ramp;
  CHECK(ramp.towards(full, 0) == Approx(6897).margin(10));  // 1000 / 145 s
  ramp.ramps.clear();
  CHECK(ramp.towards(-full, 0) == Approx(6897).margin(10));
}

TEST_CASE("deceleration has its own rate, and another one in reverse") {
  Ramp ramp;
  ramp.towards(full, 0);
  CHECK(ramp.towards(0, 0) == Approx(2083).margin(5));  // 1000 / 480 s
  ramp.towards(-full, 0);
  CHECK(ramp.towards(0, 0) == Approx(3125).margin(5));  // 1000 / 320 s
}

TEST_CASE("at pot 0 the chair starts and stops as quickly as real ones do", "[SB-00.8]") {
  Ramp ramp;
  CHECK(ramp.towards(3604, 0) == Approx(1517).margin(2));  // with 0.1 s of brakes: 1.6 to 1.9 s
  CHECK(ramp.towards(0, 0) == Approx(460).margin(100));    // 0.55 s
  ramp.towards(-3604, 0);
  CHECK(ramp.towards(0, 0) == Approx(690).margin(100));  // 0.75 s
}

TEST_CASE("a turn has rates of its own, to either side") {
  Ramp ramp;
  for (const int turn : {5734, -5734}) {
    CHECK(ramp.towards(0, turn) == Approx(1000).margin(2));  // 350 permille at 350 a second
    CHECK(ramp.towards(0, 0) == Approx(583).margin(2));      // 350 / 600 s
  }
}

TEST_CASE("each ramp's rate is exact, at both ends of its setting", "[H-21]") {
  // What 1000 ms change, or 400 ms where that is more than all: permille a second times 16.384.
  struct Case {
    Setting setting;
    int rate;
    int milliseconds;
    double change;
  };
  const Case cases[] = {
      {Setting::acceleration, 20, 1000, 327.68},           {Setting::acceleration, 2000, 400, 13107.2},
      {Setting::forward_deceleration, 100, 1000, 1638.4},  {Setting::forward_deceleration, 2000, 400, 13107.2},
      {Setting::reverse_deceleration, 100, 1000, 1638.4},  {Setting::reverse_deceleration, 2000, 400, 13107.2},
      {Setting::turn_acceleration, 50, 1000, 819.2},       {Setting::turn_acceleration, 2000, 400, 13107.2},
      {Setting::turn_deceleration, 200, 1000, 3276.8},     {Setting::turn_deceleration, 2000, 400, 13107.2},
      {Setting::emergency_deceleration, 740, 1000, 12124}, {Setting::emergency_deceleration, 2000, 400, 13107.2},
  };
  for (const Case& one : cases) {
    CAPTURE(static_cast<int>(one.setting), one.rate);
    Ramp ramp({{one.setting, one.rate}});
    const bool is_turn = one.setting == Setting::turn_acceleration || one.setting == Setting::turn_deceleration;
    const bool is_rise = one.setting == Setting::acceleration || one.setting == Setting::turn_acceleration;
    const int far = one.setting == Setting::reverse_deceleration ? -full : full;
    if (!is_rise) {
      ramp.towards(is_turn ? 0 : far, is_turn ? far : 0);
    }
    const int before = is_turn ? ramp.turn() : ramp.forward();
    if (one.setting == Setting::emergency_deceleration) {
      ramp.stop(one.milliseconds);
    } else if (is_rise) {
      ramp.run(is_turn ? 0 : far, is_turn ? far : 0, one.milliseconds);
    } else {
      ramp.run(0, 0, one.milliseconds);
    }
    const int after = is_turn ? ramp.turn() : ramp.forward();
    CHECK(std::abs(after - before) == Approx(one.change).margin(2.5));
  }
}

TEST_CASE("the slowest ramps still move every millisecond counted", "[H-21]") {
  Ramp ramp({{Setting::acceleration, 20}, {Setting::turn_acceleration, 50}});
  CHECK(ramp.towards(full, 0) == Approx(50000).margin(100));
  ramp.ramps.clear();
  CHECK(ramp.towards(0, full) == Approx(20000).margin(40));
}

TEST_CASE("a reversal passes through zero: it first brakes, then accelerates", "[H-33][H-11]") {
  Ramp ramp;
  ramp.towards(8192, 0);
  int before = ramp.left();
  bool stood_still = false;
  for (int i = 0; i < 6000; ++i) {
    ramp.run(-8192, 0, 1);
    const int now = ramp.left();
    stood_still = stood_still || now == 0;
    REQUIRE(now <= before);
    REQUIRE((now >= 0 || stood_still));
    REQUIRE(before - now <= (now >= 0 ? 8 : 3));  // 480 and 145 permille a second
    before = now;
  }
  CHECK(before == -8192);
}

TEST_CASE("a turn to the other side passes through zero too, and leaves the speed alone", "[H-33][H-11]") {
  Ramp ramp;
  ramp.towards(8192, 5000);
  int before = ramp.turn();
  bool was_straight = false;
  for (int i = 0; i < 2000; ++i) {
    ramp.run(8192, -5000, 1);
    was_straight = was_straight || ramp.turn() == 0;
    REQUIRE(ramp.forward() == 8192);
    REQUIRE((ramp.turn() >= 0 || was_straight));
    REQUIRE(before - ramp.turn() >= 0);
    REQUIRE(before - ramp.turn() <= 10);
    before = ramp.turn();
  }
  CHECK(before == -5000);
}

TEST_CASE("a smaller demand is approached by deceleration, a larger one by acceleration") {
  Ramp ramp;
  ramp.towards(8192, 0);
  CHECK(ramp.towards(4096, 0) == Approx(521).margin(3));
  CHECK(ramp.towards(8192, 0) == Approx(1724).margin(5));
}

TEST_CASE("a command that has been reached is kept to the last step") {
  Ramp ramp;
  ramp.towards(10001, -2003);
  for (int i = 0; i < 1000; ++i) {
    ramp.run(10001, -2003, 1);
    REQUIRE(ramp.left() == 7998);
    REQUIRE(ramp.right() == 12004);
  }
}

// ---- steering

TEST_CASE("from rest the chair steers at once, however slowly it gathers speed", "[H-11]") {
  // Full forward and 100 of 445 counts to the side: 0.225 * 5734 of turn, the rest of full voltage is speed.
  for (const int side : {1, -1}) {
    const Command wanted = command_of(stick(1023, 512 + side * 130), make_profile(Settings()), false);
    REQUIRE(side * wanted.turn == Approx(1288).margin(2));
    Ramp ramp;
    ramp.run(wanted.forward, wanted.turn, 50);
    CHECK(side * ramp.turn() >= 5);
    ramp.run(wanted.forward, wanted.turn, 250);
    CHECK(ramp.forward() == 712);                         // 300 ms of 2.375
    CHECK(side * ramp.turn() == Approx(60.7).margin(6));  // as much of 1288 as 712 is of 15096
    const double inner = side > 0 ? ramp.right() : ramp.left();
    const double outer = side > 0 ? ramp.left() : ramp.right();
    CHECK(inner / outer == Approx(0.843).margin(0.02));  // (15096 - 1288) / (15096 + 1288)
  }
}

TEST_CASE("from rest the curve is as asked all the way, and the inner wheel runs to no other side", "[H-11]") {
  for (const int turn : {100, 1288, 3000, 5734, -1288, -5734}) {
    for (const int forward : {full - 5734, 5734, -5734, 3000, -8000, 300}) {
      Ramp ramp;
      const int larger = std::max(std::abs(forward), std::abs(turn));
      for (int i = 0; i < 5000; ++i) {
        ramp.run(forward, turn, 1);
        CAPTURE(forward, turn, i);
        // turn / forward as asked, but for a step of the turn and one of the speed, and 1/256; wider only if the turn's
        // own ramp, 350 permille a second against 145, cannot follow
        const int sharper = std::abs(ramp.turn() * forward) - std::abs(ramp.forward() * turn);
        REQUIRE(sharper <= larger * (9 + larger / 256));
        REQUIRE((sharper >= -larger * (9 + larger / 256) || std::abs(turn) > 2 * std::abs(forward)));
        const int asked_inner = std::abs(forward) - std::abs(turn);
        const int inner = std::abs(ramp.forward()) - std::abs(ramp.turn());
        REQUIRE((asked_inner > 0 ? inner >= -9 : inner <= 9 + larger / 256));
      }
      CHECK(ramp.forward() == forward);
      CHECK(ramp.turn() == turn);
    }
  }
}

TEST_CASE("a turn on the spot has nothing to wait for, nor one with a trace of speed") {
  Ramp ramp;
  ramp.run(0, 5734, 100);
  CHECK(ramp.turn() == 573);
  ramp.ramps.clear();
  ramp.run(100, 5734, 100);
  CHECK(ramp.turn() == Approx(573).margin(20));
}

TEST_CASE("a turn that is asked to be smaller becomes smaller at once, whatever the speed") {
  Ramp ramp;
  ramp.towards(2000, 1500);
  ramp.run(12000, 500, 50);
  CHECK(ramp.turn() == Approx(1500 - 50 * 9.83).margin(1));
  CHECK(ramp.towards(12000, 500) > 0);
}

TEST_CASE("a turn that is there does not shrink when more speed is asked for", "[H-11]") {
  Ramp ramp;
  ramp.towards(2000, 1500);
  for (int i = 0; i < 3000; ++i) {
    ramp.run(12000, 1500, 1);
    REQUIRE(ramp.turn() == 1500);
  }
}

TEST_CASE("a turn while driving straight begins at once and leaves the speed as it is", "[H-11][H-33]") {
  for (const int side : {1, -1}) {
    Ramp ramp;
    ramp.towards(8192, 0);
    ramp.run(8192, side * 5734, 100);
    CHECK(ramp.forward() == 8192);
    CHECK(side * ramp.turn() == Approx(573).margin(1));
    CHECK(ramp.towards(8192, side * 5734) == Approx(900).margin(2));
    CHECK(ramp.towards(8192, 0) == Approx(583).margin(2));
  }
}

TEST_CASE("at full speed the speed makes room for a turn, and no wheel exceeds full demand", "[H-11][H-21]") {
  for (const int rate : {350, 2000}) {
    Ramp ramp(
        {{Setting::turn_acceleration, rate}, {Setting::turn_maximum, 1000}, {Setting::forward_deceleration, 100}});
    ramp.towards(full, 0);
    int spent = 0;
    while (ramp.turn() < 16000 && spent < 5000) {
      const int right = ramp.right();
      ramp.run(384, 16000, 1);
      ++spent;
      REQUIRE(ramp.left() <= full);
      REQUIRE(ramp.left() >= full - 2);
      REQUIRE(right - ramp.right() <= 2 * (rate * 16.384 / 1000 + 1));
    }
    CHECK(spent == Approx(16000 / (rate * 0.016384)).margin(2));  // as if it had stood still
    CHECK(ramp.forward() == 384);
  }
}

// ---- mirrors and bounds

TEST_CASE("left mirrors right and reverse mirrors forward, in every millisecond", "[H-11]") {
  const std::initializer_list<std::pair<Setting, int>> same = {{Setting::forward_deceleration, 480},
                                                               {Setting::reverse_deceleration, 480}};
  Ramp one(same);
  Ramp other_side(same);
  Ramp backwards(same);
  std::mt19937 generator(815);
  Command wanted;
  for (int i = 0; i < 50000; ++i) {
    if (generator() % 300 == 0) {
      wanted.turn = static_cast<std::int16_t>(static_cast<int>(generator() % 11469) - 5734);
      const int room = full - std::abs(wanted.turn);
      wanted.forward =
          static_cast<std::int16_t>(static_cast<int>(generator() % static_cast<unsigned>(2 * room + 1)) - room);
    }
    if (generator() % 4000 < 3) {
      const int milliseconds = static_cast<int>(generator() % 700);
      one.stop(milliseconds);
      other_side.stop(milliseconds);
      backwards.stop(milliseconds);
    }
    one.run(wanted.forward, wanted.turn, 1);
    other_side.run(wanted.forward, -wanted.turn, 1);
    backwards.run(-wanted.forward, -wanted.turn, 1);
    REQUIRE(one.left() == other_side.right());
    REQUIRE(one.right() == other_side.left());
    REQUIRE(one.left() == -backwards.left());
    REQUIRE(one.right() == -backwards.right());
  }
}

TEST_CASE("under any settings, commands and stops no wheel jumps or exceeds full demand", "[H-21][H-33]") {
  std::mt19937 generator(4712);
  const auto any_of = [&generator](std::initializer_list<int> values) {
    return values.begin()[generator() % values.size()];
  };
  for (int run = 0; run < 200; ++run) {
    const int rise = any_of({20, 145, 2000});
    const int drop = any_of({100, 480, 2000});
    const int turn_rise = any_of({50, 350, 2000});
    const int turn_drop = any_of({200, 600, 2000});
    Ramp ramp({{Setting::acceleration, rise},
               {Setting::forward_deceleration, drop},
               {Setting::reverse_deceleration, drop},
               {Setting::turn_acceleration, turn_rise},
               {Setting::turn_deceleration, turn_drop},
               {Setting::emergency_deceleration, any_of({740, 2000})}});
    const auto step = [](int rate) { return rate * 16384 / 1000000 + 1; };
    const int most_turn = std::max(step(turn_rise), step(turn_drop));
    const int most = std::max(std::max(step(rise), step(drop)) + most_turn, 2 * most_turn);
    Command wanted;
    bool is_stopping = false;
    for (int i = 0; i < 2000; ++i) {
      if (generator() % 256 == 0) {
        wanted.turn = static_cast<std::int16_t>(any_of({0, 1, -1, 8192, -8192, full, -full}));
        const int room = full - std::abs(wanted.turn);
        wanted.forward = static_cast<std::int16_t>(any_of({0, room, -room, room / 2, -room / 2}));
        is_stopping = generator() % 4 == 0;
      }
      const int left = ramp.left();
      const int right = ramp.right();
      if (is_stopping) {
        ramp.stop();
        REQUIRE(std::abs(ramp.left()) <= std::abs(left));
        REQUIRE(std::abs(ramp.right()) <= std::abs(right));
      } else {
        ramp.run(wanted.forward, wanted.turn, 1);
        REQUIRE(std::abs(ramp.left() - left) <= most);
        REQUIRE(std::abs(ramp.right() - right) <= most);
      }
      REQUIRE(std::abs(ramp.left()) <= full);
      REQUIRE(std::abs(ramp.right()) <= full);
    }
  }
}

// ---- emergency stop

TEST_CASE("the emergency ramp only falls, and from any command it is at zero within 1500 ms", "[SB-2.17][H-04]") {
  const Command commands[] = {command(full, 0),      command(-full, 0),     command(0, full),     command(0, -full),
                              command(10650, 5734),  command(-10650, 5734), command(8192, -8192), command(-8193, -8191),
                              command(5734, -10650), command(5000, 4999),   command(-77, 0),      command(0, 1),
                              command(3000, 1),      command(-1, 3000)};
  for (const int rate : {740, 800, 2000}) {
    for (const Command& start : commands) {
      CAPTURE(rate, start.forward, start.turn);
      Ramp ramp({{Setting::emergency_deceleration, rate}, {Setting::acceleration, 2000}});
      ramp.towards(start.forward, start.turn);
      int spent = 0;
      while (ramp.left() != 0 || ramp.right() != 0) {
        const int left = ramp.left();
        const int right = ramp.right();
        ramp.stop();
        ++spent;
        REQUIRE(std::abs(ramp.left()) <= std::abs(left));
        REQUIRE(std::abs(ramp.right()) <= std::abs(right));
        REQUIRE(ramp.left() * left >= 0);
        REQUIRE(ramp.right() * right >= 0);
        REQUIRE(spent <= 1500);
      }
      const double larger = std::max(std::abs(int{start.forward}), std::abs(int{start.turn}));
      CHECK(spent == Approx(larger / (rate * 0.016384)).margin(2));
    }
  }
}

TEST_CASE("a stop in a curve keeps the curve, and both wheels stand still in the same millisecond", "[SB-2.17]") {
  for (const int side : {1, -1}) {
    for (const Command& start : {command(10650, 5734), command(-10650, 5734), command(1000, 5734)}) {
      Ramp ramp;
      ramp.towards(start.forward, side * start.turn);
      const double first_left = ramp.left();
      const double first_right = ramp.right();
      while (std::abs(ramp.forward()) + std::abs(ramp.turn()) > 16) {
        ramp.stop();
        REQUIRE((ramp.left() == 0) == (ramp.right() == 0));
        REQUIRE(ramp.left() * first_right == Approx(ramp.right() * first_left).margin(3 * full));
      }
    }
  }
}

TEST_CASE("a stop that is broken off goes on from where it was, and a second one keeps the new curve", "[H-33]") {
  Ramp ramp;
  ramp.towards(10000, 3000);
  ramp.stop(200);
  CHECK(ramp.forward() == Approx(10000 - 200 * 13.107).margin(2));
  CHECK(ramp.turn() == Approx(3000 - 200 * 13.107 * 0.3).margin(2));
  const int left = ramp.left();
  const int right = ramp.right();
  ramp.run(10000, -3000, 1);
  CHECK(std::abs(ramp.left() - left) <= 13);  // 145 permille a second up, 600 down
  CHECK(std::abs(ramp.right() - right) <= 13);
  ramp.towards(0, 3000);
  ramp.stop(100);
  CHECK(ramp.forward() == 0);
  CHECK(ramp.turn() == Approx(3000 - 100 * 13.107).margin(2));
}

// ---- the gate's word

TEST_CASE("what the gate held back is not made up for later", "[H-33]") {
  Ramp ramp;
  ramp.towards(10000, 2000);
  ramp.ramps.yield_to(Wheels{Demand(9000), Demand(7000)});
  CHECK(ramp.left() == 9000);
  CHECK(ramp.right() == 7000);
  ramp.run(10000, 2000, 1);
  CHECK(ramp.left() == Approx(9008).margin(1));  // 2.375 and 5.734 a millisecond
  ramp.ramps.yield_to(Wheels());
  CHECK(std::abs(ramp.left()) <= 1);
  CHECK(std::abs(ramp.right()) <= 1);
}

TEST_CASE("an odd step that the gate held back is left with the ramps, on the asked side", "[H-33]") {
  for (const int forward : {3, -3}) {
    Ramp ramp({{Setting::acceleration, 2000}, {Setting::turn_acceleration, 2000}});
    ramp.towards(forward, 2);
    const int left = ramp.left();
    const int right = ramp.right();
    ramp.ramps.yield_to(Wheels{Demand(0), Demand(static_cast<std::int16_t>(right))});
    CHECK(ramp.left() == left % 2);
    CHECK(ramp.right() == right);
  }
}

TEST_CASE("cleared ramps are at rest") {
  Ramp ramp;
  ramp.towards(8192, -8192);
  ramp.ramps.clear();
  CHECK(ramp.ramps.demand().is_zero());
}

}  // namespace
