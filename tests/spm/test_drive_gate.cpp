#include "spm/drive_gate.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>

namespace {

using namespace spm;
using namespace base;

constexpr int full = 16384;

Wheels wheels(int left, int right) {
  return Wheels{Demand(static_cast<std::int16_t>(left)), Demand(static_cast<std::int16_t>(right))};
}

GateFacts all_well() {
  GateFacts facts;
  facts.may_drive = true;
  facts.allows_torque = true;
  facts.is_limping = false;
  facts.general_age = 20_ms;
  return facts;
}

struct Gate {
  DriveGate gate;
  GateFacts facts = all_well();
  Wheels out;

  int left() const { return out.left.count(); }
  int right() const { return out.right.count(); }
  Gate& pass(int left, int right) {
    out = gate.pass(wheels(left, right), facts);
    return *this;
  }
  Gate& hold(int left, int right, int times) {
    for (int i = 0; i < times; ++i) {
      pass(left, right);
    }
    return *this;
  }
};

TEST_CASE("without a word from anybody the gate is shut", "[H-01]") {
  DriveGate gate;
  for (int i = 0; i < 100; ++i) {
    CHECK(gate.pass(wheels(100, 100), GateFacts()).is_zero());
  }
}

TEST_CASE("what is slow and allowed passes unchanged") {
  Gate gate;
  for (int value = 0; value <= full; value += 2) {
    gate.pass(value, -value);
    REQUIRE(gate.left() == value);
    REQUIRE(gate.right() == -value);
  }
}

TEST_CASE("a jump is let out at 66 a millisecond and no faster, on either side", "[H-33]") {
  Gate gate;
  for (int i = 1; i <= 300; ++i) {
    gate.pass(full, -full);
    const int most = i * 66 < full ? i * 66 : full;
    REQUIRE(gate.left() == most);
    REQUIRE(gate.right() == -most);
  }
}

TEST_CASE("without leave to drive the demand falls by 12 a millisecond, whatever is asked", "[SB-2.17][H-01][H-19]") {
  Gate gate;
  gate.hold(full, -full, 300);
  gate.facts.may_drive = false;
  int expected = full;
  for (int i = 0; i < 1400; ++i) {
    gate.pass(full, -full);
    expected = expected > 12 ? expected - 12 : 0;
    REQUIRE(gate.left() == expected);
    REQUIRE(gate.right() == -expected);
  }
  CHECK(expected == 0);
}

TEST_CASE("from full speed the gate alone stops the chair within 1500 ms", "[SB-2.17][H-04]") {
  Gate gate;
  gate.hold(full, full, 300);
  gate.facts.may_drive = false;
  int spent = 0;
  while (!gate.out.is_zero()) {
    gate.pass(full, full);
    ++spent;
    REQUIRE(spent <= 1500);
  }
}

TEST_CASE("a gentler fall that was asked for without leave is overruled, a harder one is not", "[SB-2.17]") {
  Gate gate;
  gate.hold(1000, 1000, 100);
  gate.facts.may_drive = false;
  gate.pass(999, 900);
  CHECK(gate.left() == 988);
  CHECK(gate.right() == 900);
}

TEST_CASE("without leave the larger demand falls, and the smaller may keep its share of it", "[SB-2.17]") {
  Gate gate;
  gate.hold(1000, -500, 100);
  gate.facts.may_drive = false;
  gate.pass(980, -490);
  CHECK(gate.left() == 980);
  CHECK(gate.right() == -490);
  gate.pass(980, -490);  // the larger one is made to fall, the smaller one may not grow
  CHECK(gate.left() == 968);
  CHECK(gate.right() == -490);
  gate.pass(0, -500);
  CHECK(gate.left() == 0);
  CHECK(gate.right() == -490);
  gate.pass(0, -490);  // now it is the larger one
  CHECK(gate.right() == -478);
}

TEST_CASE("without leave both demands are zero within 1500 ms, whatever is asked and however they differ",
          "[SB-2.17][H-04]") {
  for (const int right : {full, 8192, 100, 1, 0, -1, -5000, -full}) {
    Gate gate;
    gate.hold(full, right, 300);
    gate.facts.may_drive = false;
    for (int i = 0; i < 1500; ++i) {
      gate.pass(full, right);
    }
    CHECK(gate.out.is_zero());
  }
}

TEST_CASE("from standstill nothing starts without leave", "[H-01]") {
  Gate gate;
  gate.facts.may_drive = false;
  gate.hold(100, -100, 1000);
  CHECK(gate.out.is_zero());
}

TEST_CASE("a general up to 66 ms old is a command, an older one is not", "[SB-2.15][H-04][H-01]") {
  Gate gate;
  gate.hold(1000, 1000, 100);
  gate.facts.general_age = 66_ms;
  CHECK(gate.pass(1010, 1010).left() == 1010);
  gate.facts.general_age = 67_ms;
  CHECK(gate.pass(1020, 1020).left() == 998);
  gate.facts.general_age = Millis(0xFFFFFFFF);
  CHECK(gate.pass(1020, 1020).left() == 986);
}

TEST_CASE("there is no torque against an engaged brake, at once", "[H-13]") {
  Gate gate;
  gate.hold(full, full, 300);
  gate.facts.allows_torque = false;
  gate.pass(full, full);
  CHECK(gate.out.is_zero());
  gate.facts.allows_torque = true;
  gate.pass(full, full);
  CHECK(gate.left() == 66);  // and it starts again from rest (H-33)
}

TEST_CASE("a wheel never changes its direction without standing still", "[H-11][H-33]") {
  Gate gate;
  gate.hold(500, -500, 100);
  gate.pass(-500, 500);
  CHECK(gate.out.is_zero());
  gate.pass(-500, 500);
  CHECK(gate.left() == -66);
  CHECK(gate.right() == 66);
}

TEST_CASE("limping, the demand stays at half of full voltage", "[SB-2.16][H-07]") {
  Gate gate;
  gate.facts.is_limping = true;
  for (int i = 0; i < 400; ++i) {
    gate.pass(full, -full);
    REQUIRE(gate.left() <= 8192);
    REQUIRE(gate.right() >= -8192);
  }
  CHECK(gate.left() == 8192);
  CHECK(gate.right() == -8192);
}

TEST_CASE("a chair that begins to limp above the ceiling falls to it without a jump", "[SB-2.16][H-07][H-33]") {
  Gate gate;
  gate.hold(full, -full, 300);
  gate.facts.is_limping = true;
  int before = full;
  for (int i = 0; i < 700; ++i) {
    gate.pass(full, -full);
    REQUIRE(gate.left() == (before > 8192 + 12 ? before - 12 : 8192));
    REQUIRE(gate.right() == -gate.left());
    before = gate.left();
  }
  CHECK(before == 8192);
}

TEST_CASE("a demand beyond full voltage is no demand: both wheels fall, and never rise again", "[H-21][H-27]") {
  for (const int nonsense : {full + 1, 32767, -full - 1, -32768}) {
    Gate gate;
    gate.hold(50, 40, 3);
    CHECK_FALSE(gate.gate.has_refused());
    gate.pass(nonsense, 40);
    CHECK(gate.left() == 38);
    CHECK(gate.right() == 38);
    CHECK(gate.gate.has_refused());
    gate.pass(50, 50);
    CHECK(gate.left() == 26);
    CHECK(gate.right() == 26);
    gate.hold(50, 50, 3);
    CHECK(gate.out.is_zero());
    gate.hold(50, 50, 10);
    CHECK(gate.out.is_zero());
    CHECK(gate.gate.has_refused());
  }
  Gate gate;
  gate.pass(0, full + 1);
  CHECK(gate.gate.has_refused());
}

TEST_CASE("whatever it is handed, the gate keeps its rules", "[H-01][H-07][H-13][H-33]") {
  std::mt19937 generator(4711);
  const auto random = [&generator](int below) { return static_cast<int>(generator() % static_cast<unsigned>(below)); };
  Gate gate;
  for (int i = 0; i < 200000; ++i) {
    const int left = gate.left();
    const int right = gate.right();
    if (random(50) == 0) {
      gate.facts.may_drive = random(4) != 0;
      gate.facts.allows_torque = random(8) != 0;
      gate.facts.is_limping = random(2) == 0;
      gate.facts.general_age = Millis(static_cast<std::uint32_t>(random(80)));
    }
    if (gate.gate.has_refused() && random(20) == 0) {
      gate.gate = DriveGate();
      gate.out = Wheels();
      continue;
    }
    gate.pass(random(1000) == 0 ? random(65536) - 32768 : random(2 * full + 1) - full, random(2) * full);
    const int fallen = std::max(0, std::max(std::abs(left), std::abs(right)) - 12);
    for (const auto& [before, after] : {std::pair{left, gate.left()}, std::pair{right, gate.right()}}) {
      const int grown = std::abs(after) - std::abs(before);
      const bool may_rise = gate.facts.may_drive && !gate.gate.has_refused() && gate.facts.general_age <= 66_ms;
      REQUIRE(std::abs(after) <= full);
      REQUIRE(grown <= 66);
      REQUIRE((before == 0 || after == 0 || (before > 0) == (after > 0)));
      if (!may_rise) {
        REQUIRE(std::abs(after) <= std::min(std::abs(before), fallen));
      }
      if (!gate.facts.allows_torque) {
        REQUIRE(after == 0);
      }
      if (gate.facts.is_limping) {
        REQUIRE(std::abs(after) <= std::max(8192, std::abs(before) - 12));
      }
    }
  }
}

}  // namespace
