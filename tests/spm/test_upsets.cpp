// Every bit of everything the power module remembers, flipped once, at rest and while driving (H-27). What is judged is
// what leaves it: motors and brakes. Nothing here knows which bit means what.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "spm/spm.hpp"
#include "tests/support/wire_words.hpp"

namespace {

using namespace support;

// A flipped bit makes numbers that no program makes: sums may wrap, a bool may be 2. What comes of it is judged here; a
// sanitizer would stop at once.
#ifdef __SANITIZE_ADDRESS__
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

// What the motors do after a flip.
struct Verdict {
  bool has_moved = false;       // any demand, or a brake released
  bool has_leapt = false;       // a demand grew faster than the hard limit, beyond full, or across zero
  bool has_dropped = false;     // a demand fell faster than any ramp
  bool has_grown_late = false;  // or grew more than 5 ms after it had to fall
  bool has_let_go = false;      // of the supply, not at rest (H-14)
  int largest = 0;              // demand of a wheel
  int stopped_after = -1;       // ms after the stick was let go or the cable cut
  bool is_braked_at_end = false;
};

// A power module that hears a general every 20 ms.
class Rig {
 public:
  Rig() {
    in_.battery = base::Millivolts(24000);
    in_.analog_ready = true;
    hear(wire::sr_power_up);
  }

  void drive(const Bytes& general, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      hear(general);
    }
  }
  // Nothing is heard.
  void silence(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      ++now_;
      step_at(now_ * 1000);
    }
  }

  std::size_t bits() const { return sizeof(spm::Spm) * 8; }
  void flip(std::size_t bit) {
    auto* bytes = reinterpret_cast<unsigned char*>(&spm_);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1U << (bit % 8)));
  }

  void begin_to_judge() {
    verdict_ = Verdict();
    last_left_ = out_.left.count();
    last_right_ = out_.right.count();
  }
  void must_fall_from_now_on() { must_fall_since_ = static_cast<int>(now_); }
  Verdict verdict() const {
    Verdict verdict = verdict_;
    verdict.is_braked_at_end = is_braked();
    return verdict;
  }
  spm::Inputs& inputs() { return in_; }
  const spm::Outputs& out() const { return out_; }
  const spm::Spm& spm() const { return spm_; }

 private:
  bool is_braked() const { return out_.left_brake == spm::Brake::engaged && out_.right_brake == spm::Brake::engaged; }

  void hear(const Bytes& packet) {
    Bytes turn = packet + wire::tf;
    for (int i = 0; i < 20; ++i) {
      ++now_;
      const std::uint32_t at = now_ * 1000;
      for (std::size_t k = 0; k < 3 && !turn.empty(); ++k) {
        in_.heard[0] = base::HeardByte{turn.front(), false, base::Stamp(static_cast<std::uint16_t>(at + k * 286))};
        in_.heard_count = 1;
        turn.erase(turn.begin());
        step_at(at + static_cast<std::uint32_t>(k) * 286);
      }
      step_at(at + 999);
    }
  }

  void step_at(std::uint32_t microseconds) {
    in_.stamp = base::Stamp(static_cast<std::uint16_t>(microseconds));
    in_.brake_coils = base::Milliamps(is_braked() ? 0 : 1300);
    out_ = spm_.step(in_, base::Instant(microseconds / 1000));
    in_.heard_count = 0;
    judge();
  }

  void judge() {
    const int left = out_.left.count();
    const int right = out_.right.count();
    verdict_.largest = std::max({verdict_.largest, std::abs(left), std::abs(right)});
    verdict_.has_moved = verdict_.has_moved || left != 0 || right != 0 || !is_braked();
    verdict_.has_let_go =
        verdict_.has_let_go || (out_.latch == spm::Latch::release && (left != 0 || right != 0 || !is_braked()));
    const bool grows = judge_wheel(left, last_left_) | judge_wheel(right, last_right_);
    last_left_ = left;
    last_right_ = right;
    if (must_fall_since_ >= 0) {
      const int spent = static_cast<int>(now_) - must_fall_since_;
      verdict_.has_grown_late = verdict_.has_grown_late || (grows && spent > 5);
      const bool is_still = left == 0 && right == 0;
      verdict_.stopped_after = !is_still ? -1 : verdict_.stopped_after < 0 ? spent : verdict_.stopped_after;
    }
  }

  bool judge_wheel(int demand, int before) {
    const bool has_crossed = (demand < 0 && before > 0) || (demand > 0 && before < 0);
    const int rise = std::abs(demand) - std::abs(before);
    verdict_.has_leapt = verdict_.has_leapt || std::abs(demand) > 16384 || has_crossed || rise > 5 * 66;
    verdict_.has_dropped = verdict_.has_dropped || rise < -5 * 27;
    return rise > 0;
  }

  spm::Spm spm_;
  spm::Inputs in_;
  spm::Outputs out_;
  std::uint32_t now_ = 0;
  Verdict verdict_;
  int last_left_ = 0;
  int last_right_ = 0;
  int must_fall_since_ = -1;
};

Rig ready() {
  Rig rig;
  rig.drive(wire::at_rest, 50);
  return rig;
}

Rig driving() {
  Rig rig = ready();
  rig.drive(wire::forward_fast, 400);
  return rig;
}

// The bits after whose flip `is_safe` does not hold, as text.
template <typename Play, typename IsSafe>
std::string unsafe_bits(const Rig& start, Play play, IsSafe is_safe) {
  std::string unsafe;
  int count = 0;
  for (std::size_t bit = 0; bit < start.bits() && !is_sanitized; ++bit) {
    Rig rig = start;
    rig.begin_to_judge();
    rig.flip(bit);
    play(rig);
    const Verdict verdict = rig.verdict();
    if (verdict.has_leapt || verdict.has_dropped || verdict.has_let_go || !is_safe(verdict)) {
      ++count;
      if (count <= 100) {
        unsafe += std::to_string(bit / 8) + "." + std::to_string(bit % 8) + " ";
      }
    }
  }
  return unsafe + (count > 100 ? "... " + std::to_string(count) : "");
}

TEST_CASE("no flipped bit moves a chair whose stick rests", "[H-27][H-01]") {
  const auto play = [](Rig& rig) { rig.drive(wire::at_rest, 50); };
  CHECK(unsafe_bits(ready(), play, [](const Verdict& verdict) { return !verdict.has_moved; }) == "");
}

TEST_CASE("no flipped bit moves a chair whose stick was never let go", "[H-27][H-02]") {
  Rig start;
  start.drive(wire::forward_fast, 50);
  const auto play = [](Rig& rig) { rig.drive(wire::forward_fast, 50); };
  CHECK(unsafe_bits(start, play, [](const Verdict& verdict) { return !verdict.has_moved; }) == "");
}

TEST_CASE("no flipped bit keeps a driving chair from stopping when the stick is let go, nor makes it leap",
          "[H-27][H-03]") {
  const auto play = [](Rig& rig) {
    rig.drive(wire::forward_fast, 10);
    rig.must_fall_from_now_on();
    rig.drive(wire::at_rest, 170);
  };
  CHECK(unsafe_bits(driving(), play, [](const Verdict& verdict) {
          return !verdict.has_grown_late && verdict.is_braked_at_end && verdict.stopped_after >= 0 &&
                 verdict.stopped_after <= 2150;
        }) == "");
}

TEST_CASE("no flipped bit keeps a driving chair from stopping when the cable is cut", "[H-27][H-04]") {
  const auto play = [](Rig& rig) {
    rig.drive(wire::forward_fast, 10);
    rig.must_fall_from_now_on();
    rig.silence(1830);
  };
  CHECK(unsafe_bits(driving(), play, [](const Verdict& verdict) {
          return verdict.is_braked_at_end && verdict.stopped_after >= 0 && verdict.stopped_after <= 1562;
        }) == "");
}

TEST_CASE("no flipped bit keeps a chair that turns backwards from stopping", "[H-27][H-03][H-04]") {
  Rig start = ready();
  start.drive(sr_general({200, 700, 255}), 150);
  const auto is_safe = [](const Verdict& verdict) {
    return !verdict.has_grown_late && verdict.is_braked_at_end && verdict.stopped_after >= 0;
  };
  const auto let_go = [](Rig& rig) {
    rig.drive(sr_general({200, 700, 255}), 3);
    rig.must_fall_from_now_on();
    rig.drive(wire::at_rest, 170);
  };
  CHECK(unsafe_bits(start, let_go, is_safe) == "");
  const auto inhibit = [](Rig& rig) {
    rig.drive(sr_general({200, 700, 255}), 3);
    rig.drive(sr_general({200, 700, 255, 0, 0x08, 0}), 1);
    rig.must_fall_from_now_on();
    rig.drive(sr_general({200, 700, 255, 0, 0x08, 0}), 88);
  };
  CHECK(unsafe_bits(start, inhibit, is_safe) == "");
}

TEST_CASE("no flipped bit gives torque worth the name before the brakes had their time", "[H-27][H-13]") {
  Rig start = ready();
  start.drive(wire::forward_fast, 2);
  REQUIRE(start.out().left_brake == spm::Brake::released);
  REQUIRE(start.out().left.count() == 0);
  const auto play = [](Rig& rig) { rig.silence(40); };
  // The coils are on already; what a ramp makes of the rest of their time is less than one percent.
  CHECK(unsafe_bits(start, play, [](const Verdict& verdict) { return verdict.largest <= 164; }) == "");
}

TEST_CASE("every flipped bit of a setting is noticed while driving: the chair stops by a ramp, and says why",
          "[H-27][H-21][SB-01.9]") {
  const Rig start = driving();
  for (std::size_t bit = 0; bit < sizeof(spm::Settings) * 8 && !is_sanitized; ++bit) {
    Rig rig = start;
    rig.begin_to_judge();
    auto& settings = const_cast<spm::Settings&>(rig.spm().settings());
    auto* bytes = reinterpret_cast<unsigned char*>(&settings);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1U << (bit % 8)));
    rig.drive(wire::forward_fast, 3);
    CAPTURE(bit);
    REQUIRE(rig.spm().faults().must_stop);
    REQUIRE(int(rig.spm().faults().system_state) == 8);
    rig.drive(wire::forward_fast, 85);
    REQUIRE(rig.out().left.count() == 0);
    REQUIRE(rig.out().left_brake == spm::Brake::engaged);
    REQUIRE_FALSE(rig.verdict().has_dropped);
    for (std::uint8_t i = 0; i < spm::setting_count; ++i) {
      const spm::SettingRange range = spm::range_of(static_cast<spm::Setting>(i));
      REQUIRE(settings[static_cast<spm::Setting>(i)] >= range.least);
      REQUIRE(settings[static_cast<spm::Setting>(i)] <= range.most);
    }
  }
}

TEST_CASE("no flipped bit drives a chair that a stuck output has stopped for good", "[H-27][H-10]") {
  Rig start = ready();
  start.inputs().left_current = base::Milliamps(20000);
  start.drive(wire::at_rest, 5);
  start.inputs().left_current = base::Milliamps(0);
  start.drive(wire::at_rest, 20);
  const auto play = [](Rig& rig) {
    rig.drive(wire::at_rest, 10);
    rig.drive(wire::forward_fast, 30);
  };
  CHECK(unsafe_bits(start, play, [](const Verdict& verdict) { return !verdict.has_moved; }) == "");
}

TEST_CASE("no flipped bit makes a limping chair fast", "[H-27][H-07]") {
  Rig start = ready();
  start.silence(100);
  start.drive(wire::at_rest, 20);
  start.drive(wire::forward_fast, 250);
  REQUIRE(start.out().left.count() == Approx(6554).margin(1));
  const auto play = [](Rig& rig) { rig.drive(wire::forward_fast, 50); };
  CHECK(unsafe_bits(start, play, [](const Verdict& verdict) { return verdict.largest <= 6554 + 10 * 66; }) == "");
}

}  // namespace
