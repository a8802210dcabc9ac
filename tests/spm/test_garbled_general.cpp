// spm: what noise makes of one general. Every two flipped bits of it, and every two of its bytes in each other's place,
// sent in its stead: what the 7-bit sum misses (3 to 5 % of the flips, nearly all of the swaps) as well as what it
// finds. One packet may take drive away; none may give it (H-06).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <utility>

#include "tests/support/bench.hpp"

using support::Bench;
using support::Bytes;
using support::operator+;
using support::sr_general;
using support::SrWords;
namespace wire = support::wire;

namespace {

// Each pair of bits of a packet.
std::vector<Bytes> double_flips(const Bytes& packet) {
  std::vector<Bytes> all;
  const std::size_t bits = packet.size() * 8;
  for (std::size_t first = 0; first < bits; ++first) {
    for (std::size_t second = first + 1; second < bits; ++second) {
      Bytes flipped = packet;
      flipped[first / 8] ^= static_cast<std::uint8_t>(1U << first % 8);
      flipped[second / 8] ^= static_cast<std::uint8_t>(1U << second % 8);
      all.push_back(flipped);
    }
  }
  return all;
}

// And each pair of its bytes in each other's place, start byte and checksum included.
std::vector<Bytes> garblings(const Bytes& packet) {
  std::vector<Bytes> all = double_flips(packet);
  for (std::size_t first = 0; first < packet.size(); ++first) {
    for (std::size_t second = first + 1; second < packet.size(); ++second) {
      Bytes swapped = packet;
      std::swap(swapped[first], swapped[second]);
      all.push_back(swapped);
    }
  }
  return all;
}

// A whole packet for the document: markers, length and sum are right.
bool is_sound(const Bytes& packet) {
  const bool has_markers = std::all_of(packet.begin() + 1, packet.end(), [](auto byte) { return byte >= 0x80; });
  if (packet[0] >= 0x80 || !has_markers || packet[0] / 16U + 3U != packet.size()) {
    return false;
  }
  return support::checksum_of(Bytes(packet.begin(), packet.end() - 1)) == packet.back();
}

using Check = std::function<void(const Bench&)>;

// A turn with that packet and the rest of its 20 ms, looked at every millisecond.
void take_cycle(Bench& bench, const Bytes& packet, const Check& check) {
  const support::Microseconds end = bench.now() + 20000;
  bench.hear(packet + wire::tf);
  while (bench.now() < end) {
    check(bench);
    bench.run_until(std::min(end, bench.now() + 1000));
  }
  check(bench);
}

// From each `begin` on: in the place of one `real` general comes what noise makes of it, then real ones again.
void for_each_garbling(const Bench& begin, const Bytes& real, const Check& check, int afterwards = 8) {
  int sound = 0;
  for (const Bytes& garbled : garblings(real)) {
    Bench bench = begin;
    INFO("garbled: " << Catch::rangeToString(garbled));
    take_cycle(bench, garbled, check);
    for (int i = 0; i < afterwards; ++i) {
      take_cycle(bench, real, check);
    }
    sound += is_sound(garbled) ? 1 : 0;
  }
  CHECK(sound >= 60);  // of 2556 and 36
}

void must_be_at_rest(const Bench& bench) {
  if (!bench.is_still() || !bench.is_braked()) {
    FAIL("it moves, or lets go of its brakes");
  }
}

// Full forward, pot 255, with some bits.
Bytes forward_with(unsigned byte4, unsigned byte5, unsigned byte6) {
  return sr_general(SrWords{1023, 512, 255, byte4, byte5, byte6});
}

Bench ready_and_told(const Bytes& packet) {
  Bench bench = Bench::ready();
  bench.cycle(packet, 10);
  return bench;
}

// The link was lost at full speed and the chair is on its way to rest; nobody speaks.
Bench stopping() {
  Bench bench = Bench::driving();
  bench.run_ms(100);
  return bench;
}

}  // namespace

TEST_CASE("of two flipped bits in a general the sum misses one in 20", "[H-06]") {
  const std::vector<Bytes> all = double_flips(forward_with(0, 0, 0));
  CHECK(all.size() == 2556);
  CHECK(std::count_if(all.begin(), all.end(), is_sound) == 125);
}

TEST_CASE("no garbled general ends an emergency stop", "[H-05][H-06][H-08][SB-2.16]") {
  const Bench begin = stopping();
  REQUIRE(begin.is_transient());
  for (const Bytes& garbled : garblings(wire::forward_fast)) {
    Bench bench = begin;
    INFO("garbled: " << Catch::rangeToString(garbled));
    int left = bench.left();
    int right = bench.right();
    REQUIRE(left > 10000);
    const Check falls = [&](const Bench& now) {
      if (std::abs(now.left()) > std::abs(left) || std::abs(now.right()) > std::abs(right)) {
        FAIL("a demand grows in an emergency stop");
      }
      if (!now.is_transient() || !now.is_limping()) {
        FAIL("the emergency stop or LIMP is over");
      }
      left = now.left();
      right = now.right();
    };
    take_cycle(bench, garbled, falls);
    for (int i = 0; i < 80; ++i) {
      bench.run_ms(20);
      falls(bench);
    }
    CHECK(bench.is_still());
  }
}

TEST_CASE("no garbled general brings back a chair that an emergency stop has brought to rest", "[H-06][SB-2.16]") {
  Bench begin = stopping();
  begin.run_ms(2500);
  must_be_at_rest(begin);
  for (const Bytes& garbled : garblings(wire::forward_fast)) {
    Bench bench = begin;
    INFO("garbled: " << Catch::rangeToString(garbled));
    for (int i = 0; i < 2; ++i) {  // and not a second one either
      take_cycle(bench, garbled, must_be_at_rest);
      bench.run_ms(100);
      must_be_at_rest(bench);
      CHECK(bench.is_transient());
      CHECK(bench.is_limping());
    }
  }
}

TEST_CASE("no garbled general releases an inhibit", "[H-06][H-19][SB-01.8]") {
  // Joystick error, local fault, charger; remote inhibit, calibration.
  const Bytes inhibited = GENERATE(forward_with(0x40, 0, 0), forward_with(0x10, 0, 0), forward_with(0x08, 0, 0),
                                   forward_with(0, 0x08, 0), forward_with(0, 0x02, 0));
  for_each_garbling(ready_and_told(inhibited), inhibited, must_be_at_rest);
}

TEST_CASE("no garbled general releases an inhibit of a stick at rest", "[H-06][H-19][SB-01.2]") {
  const Bytes inhibited =
      GENERATE(wire::joystick_error, wire::local_fault, wire::charger_inhibit, wire::remote_inhibit, wire::calibrating);
  const Check stays = [](const Bench& bench) {
    must_be_at_rest(bench);
    if (bench.last_turn()[0] == 0x61 && !bench.is_inhibit_shown()) {
      FAIL("no inhibit is told");
    }
  };
  for_each_garbling(ready_and_told(inhibited), inhibited, stays);
}

TEST_CASE("no garbled general makes another mode drive", "[H-06][H-17][SB-00.7]") {
  const Bytes other = GENERATE(forward_with(0, 0, 1), forward_with(0, 0, 4), forward_with(0, 0, 8));
  for_each_garbling(ready_and_told(other), other, must_be_at_rest);
}

TEST_CASE("no garbled general is neutral enough for a stick that is held", "[H-02][H-06][SB-01.8]") {
  Bench held = Bench::greeted();
  held.cycle(wire::forward_fast, 10);
  for_each_garbling(held, wire::forward_fast, must_be_at_rest);
}

TEST_CASE("no garbled general sets a resting chair in motion", "[H-01][H-06]") {
  const Check still = [](const Bench& bench) {
    if (!bench.is_still()) {
      FAIL("it moves");
    }
  };
  for_each_garbling(Bench::ready(), wire::at_rest, still);
}

TEST_CASE("no garbled general confirms a power-down", "[H-06][H-16][SB-4.3]") {
  Bench asked = Bench::ready();
  asked.cycle(wire::button_down, 5);
  asked.cycle(wire::at_rest, 5);
  REQUIRE(asked.is_power_down_asked());
  const Check stays_on = [](const Bench& bench) {
    if (bench.is_off()) {
      FAIL("the latch was let go");
    }
  };
  for_each_garbling(asked, wire::at_rest, stays_on, 20);
}

TEST_CASE("no garbled general asks for power-down", "[H-06][H-16][SB-4.1]") {
  const Check is_not_asked = [](const Bench& bench) {
    if (bench.turns().back().bytes.size() >= 9 && bench.turns().back().bytes[0] == 0x61 &&
        bench.is_power_down_asked()) {
      FAIL("power down now");
    }
  };
  for_each_garbling(Bench::ready(), wire::at_rest, is_not_asked);
}

TEST_CASE("no garbled general clears LIMP, and its cap holds", "[H-06][H-07][SB-2.16]") {
  Bench limping = Bench::ready();
  limping.run_ms(100);
  limping.cycle(wire::at_rest, 20);
  limping.cycle(wire::forward_fast, 200);
  REQUIRE(limping.left() > 6500);
  const Check limps = [](const Bench& bench) {
    if (!bench.is_limping() || bench.left() > 6554 || bench.right() > 6554) {  // 40 % of 16384
      FAIL("LIMP is over, or its cap does not hold");
    }
  };
  for_each_garbling(limping, wire::forward_fast, limps);
}

TEST_CASE("a garbled general raises the speed by one cycle's ramp at most", "[H-06][H-33][SB-00.8]") {
  struct Creep {
    Bytes packet;
    int ramp;  // of one wheel
  };
  // Forward at 8 %: 608/256 of speed and 1468/256 of turn a millisecond, 21 of them. And backward in a bend, where a
  // turn that ends, at 2517/256, adds to the outer wheel.
  const Creep creep =
      GENERATE(Creep{sr_general(SrWords{576, 512, 255}), 171}, Creep{sr_general(SrWords{440, 560, 255}), 257});
  const Bytes& slow = creep.packet;
  Bench creeping = Bench::ready();
  creeping.cycle(slow, 200);
  const int left = std::abs(creeping.left());
  const int right = std::abs(creeping.right());
  REQUIRE(left + right > 1000);
  const int ramp = creep.ramp;
  const Check rises_little = [&](const Bench& bench) {
    if (std::abs(bench.left()) > left + ramp || std::abs(bench.right()) > right + ramp) {
      FAIL("more than a ramp: " << left << " to " << bench.left() << ", " << right << " to " << bench.right());
    }
  };
  for_each_garbling(creeping, slow, rises_little, 3);
}

TEST_CASE("no garbled general ends the LIMP of the remote's non-critical fault", "[H-06][H-07][SB-00.6]") {
  const Bytes limping = sr_general(SrWords{1023, 512, 255, 0, 0, 0x20});
  Bench begin = Bench::ready();
  begin.cycle(limping, 200);
  REQUIRE(begin.is_limping());
  const Check limps = [](const Bench& bench) {
    if (!bench.is_limping() || bench.left() > 6554 || bench.right() > 6554) {  // 40 % of 16384
      FAIL("LIMP is over, or its cap does not hold");
    }
  };
  for_each_garbling(begin, limping, limps);
}
