// spm: every stick position at many pots: signs, bounds and symmetry of what the wheels are asked to do (H-11). That
// the chip computes the same is shown in tests/simulation/vectors/test_sticks.cpp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "spm/settings.hpp"
#include "tests/vectors/sticks.hpp"

namespace {

constexpr int neutral = 512;
constexpr int deadband = 30;    // SB-00.8
constexpr int full = 16384;     // all of the motor voltage
constexpr int limp_cap = 6554;  // 40 % of it, SB-2.16
constexpr int last = 1023;

int sign(int value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}
int told(int reading) {
  return std::abs(reading - neutral) <= deadband ? 0 : sign(reading - neutral);
}

// How many positions broke which rule; all are 0.
struct Breaches {
  std::uint64_t positions = 0;
  std::uint64_t direction = 0;  // against the stick, or motion of a stick at rest
  std::uint64_t side = 0;
  std::uint64_t bounds = 0;
  std::uint64_t symmetry = 0;
  std::uint64_t order = 0;  // less speed for more stick

  std::uint64_t sum() const { return direction + side + bounds + symmetry + order; }
};

class Looker {
 public:
  Looker(std::uint8_t pot, bool is_limping) : pot_(pot), is_limping_(is_limping) {}

  void look(int speed, int direction) {
    const spm::Wheels wheels = at(speed, direction);
    const int left = wheels.left.count();
    const int right = wheels.right.count();
    const int cap = is_limping_ ? limp_cap : full;
    ++seen.positions;
    // Speed gives way to a turn, so it may be zero there; it is never the wrong one. A turn never gives way.
    const int forward = sign(left + right);
    seen.direction += forward != told(speed) && (forward != 0 || std::abs(left - right) / 2 < cap) ? 1 : 0;
    seen.side += sign(left - right) != told(direction) ? 1 : 0;
    seen.bounds += std::abs(left) > cap || std::abs(right) > cap ? 1 : 0;
    if (speed > 0 && direction > 0) {
      const spm::Wheels mirrored = at(speed, 2 * neutral - direction);
      const spm::Wheels reversed = at(2 * neutral - speed, direction);
      seen.symmetry += mirrored.left.count() != right || mirrored.right.count() != left ? 1 : 0;
      seen.symmetry += reversed.left.count() != -right || reversed.right.count() != -left ? 1 : 0;
    }
    if (speed < last) {
      const spm::Wheels more = at(speed + 1, direction);
      seen.order += more.left.count() + more.right.count() < left + right ? 1 : 0;
    }
    if (direction < last) {
      const spm::Wheels more = at(speed, direction + 1);
      seen.order += more.left.count() - more.right.count() < left - right ? 1 : 0;
    }
  }

  Breaches seen;

 private:
  spm::Wheels at(int speed, int direction) const {
    return vectors::wheels_of(static_cast<std::uint16_t>(speed), static_cast<std::uint16_t>(direction), pot_,
                              is_limping_, profile_);
  }

  std::uint8_t pot_;
  bool is_limping_;
  spm::DriveProfile profile_ = spm::make_profile(spm::Settings());
};

void look_at_all(int pot, bool is_limping) {
  Looker looker(static_cast<std::uint8_t>(pot), is_limping);
  for (int speed = 0; speed <= last; ++speed) {
    for (int direction = 0; direction <= last; ++direction) {
      looker.look(speed, direction);
    }
  }
  CAPTURE(pot, is_limping);
  CHECK(looker.seen.positions == 1048576);
  CHECK(looker.seen.direction == 0);
  CHECK(looker.seen.side == 0);
  CHECK(looker.seen.bounds == 0);
  CHECK(looker.seen.symmetry == 0);
  CHECK(looker.seen.order == 0);
}

}  // namespace

TEST_CASE("the wheels follow the stick, for every position at every fifteenth reading of the pot", "[H-11][SB-00.8]") {
  const int pot = GENERATE(range(0, 256, 15));  // 0 and 255 among them
  look_at_all(pot, false);
  look_at_all(pot, true);
}

// The long form: build/unit "[campaign]"
TEST_CASE("the wheels follow the stick, for every position of stick and pot", "[.][campaign]") {
  const int pot = GENERATE(range(0, 256));
  look_at_all(pot, false);
  look_at_all(pot, true);
}
