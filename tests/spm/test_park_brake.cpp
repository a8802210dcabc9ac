#include "spm/park_brake.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace spm;
using namespace base;

constexpr ParkBrake::Times times{100_ms, 800_ms, 150_ms};

struct Brakes {
  ParkBrake brake;
  std::uint32_t now = 0xFFFFFFFF - 50;  // across the wrap
  bool wants_motion = false;
  bool may_drive = true;
  bool may_release = true;
  bool are_coils_on = true;
  bool is_demand_zero = true;

  void pass(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      brake.step(times, ParkBrake::Facts{wants_motion, may_drive, may_release, are_coils_on, is_demand_zero},
                 Instant(++now));
    }
  }
  // Milliseconds until the coils are off, at most 10 s.
  int until_engaged() {
    int spent = 0;
    while (brake.is_released() && spent < 10000) {
      pass(1);
      ++spent;
    }
    return spent;
  }
  void drive() {
    wants_motion = true;
    pass(200);
    is_demand_zero = false;
    pass(100);
  }
};

TEST_CASE("brakes are engaged to begin with and stay so at rest", "[H-12]") {
  Brakes brakes;
  CHECK_FALSE(brakes.brake.is_released());
  brakes.pass(10000);
  CHECK_FALSE(brakes.brake.is_released());
  CHECK_FALSE(brakes.brake.allows_torque());
}

TEST_CASE("brakes are not released before the outputs were tested", "[H-10]") {
  Brakes brakes;
  brakes.wants_motion = true;
  brakes.may_release = false;
  brakes.pass(10000);
  CHECK_FALSE(brakes.brake.is_released());
  brakes.may_release = true;
  brakes.pass(1);
  CHECK(brakes.brake.is_released());
}

TEST_CASE("no torque before the coils were seen to be on", "[H-13]") {
  Brakes brakes;
  brakes.wants_motion = true;
  brakes.are_coils_on = false;
  brakes.pass(10000);
  CHECK(brakes.brake.is_released());
  CHECK_FALSE(brakes.brake.allows_torque());
  brakes.are_coils_on = true;
  brakes.pass(1);
  CHECK(brakes.brake.allows_torque());
}

TEST_CASE("brakes are not released without leave to drive", "[H-12][H-19]") {
  Brakes brakes;
  brakes.may_drive = false;
  brakes.wants_motion = true;
  brakes.pass(10000);
  CHECK_FALSE(brakes.brake.is_released());
}

TEST_CASE("torque comes once the coils have been on for the release time", "[H-13]") {
  Brakes brakes;
  brakes.wants_motion = true;
  brakes.pass(1);
  CHECK(brakes.brake.is_released());
  CHECK_FALSE(brakes.brake.allows_torque());
  brakes.pass(99);
  CHECK_FALSE(brakes.brake.allows_torque());
  brakes.pass(1);
  CHECK(brakes.brake.allows_torque());
}

TEST_CASE("brakes that were being released engage at once when leave is taken", "[H-12][H-19]") {
  Brakes brakes;
  brakes.wants_motion = true;
  brakes.pass(50);
  brakes.may_drive = false;
  brakes.pass(1);
  CHECK_FALSE(brakes.brake.is_released());
  CHECK_FALSE(brakes.brake.allows_torque());
}

TEST_CASE("a stick let go while brakes are being released lets them finish and engages them later") {
  Brakes brakes;
  brakes.wants_motion = true;
  brakes.pass(50);
  brakes.wants_motion = false;
  brakes.pass(60);
  CHECK(brakes.brake.allows_torque());
  CHECK(brakes.until_engaged() == Approx(791).margin(2));
}

TEST_CASE("brakes stay released while there is a demand, whatever else", "[H-13]") {
  Brakes brakes;
  brakes.drive();
  brakes.wants_motion = false;
  brakes.may_drive = false;
  brakes.pass(5000);
  CHECK(brakes.brake.is_released());
}

TEST_CASE("at a standstill that was wished for, brakes engage after the engage time", "[SB-2.17]") {
  Brakes brakes;
  brakes.drive();
  brakes.wants_motion = false;
  brakes.is_demand_zero = true;
  CHECK(brakes.until_engaged() == 800);
}

TEST_CASE("at a standstill that was forced, brakes engage after the shorter time", "[SB-2.17]") {
  Brakes brakes;
  brakes.drive();
  brakes.may_drive = false;
  brakes.is_demand_zero = true;
  CHECK(brakes.until_engaged() == 150);
}

TEST_CASE("leave taken at a standstill engages brakes as if it had been taken before", "[SB-2.17]") {
  Brakes brakes;
  brakes.drive();
  brakes.wants_motion = false;
  brakes.is_demand_zero = true;
  brakes.pass(400);
  CHECK(brakes.brake.is_released());
  brakes.may_drive = false;
  brakes.pass(1);
  CHECK_FALSE(brakes.brake.is_released());
}

TEST_CASE("a new wish to drive before the engage time is over keeps brakes released") {
  Brakes brakes;
  brakes.drive();
  brakes.is_demand_zero = true;
  brakes.wants_motion = false;
  brakes.pass(799);
  brakes.wants_motion = true;
  brakes.pass(1);
  brakes.wants_motion = false;
  brakes.pass(799);
  CHECK(brakes.brake.allows_torque());
  brakes.pass(1);
  CHECK_FALSE(brakes.brake.is_released());
}

TEST_CASE("brakes engage at once when they must, in any state", "[H-10]") {
  for (const int driven : {1, 60, 200}) {
    Brakes brakes;
    brakes.wants_motion = true;
    brakes.pass(driven);
    REQUIRE(brakes.brake.is_released());
    brakes.brake.engage();
    CHECK_FALSE(brakes.brake.is_released());
    CHECK_FALSE(brakes.brake.allows_torque());
  }
}

}  // namespace
