// The power module as a listener that must not be left alone: corrupt packets, silence, and what ends them
// (SB-2.10 to SB-2.18).
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

// ---- three corrupt packets

TEST_CASE("three corrupt packets in a row stop the chair and leave it limping", "[SB-2.14][SB-2.17][H-05]") {
  Bench bench = Bench::driving();
  REQUIRE(bench.left() == 16384);
  bench.cycle(corrupted(wire::forward_fast), 2);
  CHECK_FALSE(bench.is_transient());
  CHECK_FALSE(bench.is_limping());
  CHECK(bench.left() == 16384);
  bench.hear(corrupted(wire::forward_fast));
  CHECK(bench.is_transient());
  CHECK(bench.is_limping());
  CHECK(bench.has_event(spm::EventCode::corrupt_packets));
  bench.run_ms(2);
  CHECK(bench.left() < 16384);
}

TEST_CASE("two corrupt packets between sound ones are borne for ever", "[SB-2.14][H-05]") {
  Bench bench = Bench::driving();
  for (int i = 0; i < 100; ++i) {
    bench.hear(corrupted(wire::forward_fast), 2);
    bench.cycle(wire::forward_fast);
  }
  CHECK_FALSE(bench.is_limping());
  CHECK(bench.left() == 16384);
}

TEST_CASE("a packet of an unknown type ends a run of corrupt ones", "[SB-2.14][SB-5.1][H-05]") {
  for (const Bytes& sound : {wire::unknown_type, Bytes{0x1F, 0x80, 0x80, 0xE0}, packet_of(1, 7), packet_of(10, 2)}) {
    Bench bench = Bench::ready();
    bench.hear(corrupted(wire::at_rest), 2);
    bench.hear(sound);
    bench.hear(corrupted(wire::at_rest), 2);
    CHECK_FALSE(bench.is_transient());
    bench.hear(corrupted(wire::at_rest));
    CHECK(bench.is_transient());
  }
}

TEST_CASE("packets of unknown types are no corruption, however many", "[SB-5.1][SB-2.6]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 20; ++i) {
    bench.cycle(wire::at_rest + Bytes{0x1F, 0x80, 0x80, 0xE0} + wire::unknown_type + packet_of(14, 3));
  }
  bench.hear(packet_of(12, 8), 5);
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("every way of being corrupt counts", "[SB-2.10][SB-5.3][SB-2.11][SB-2.14]") {
  struct Case {
    const char* name;
    void (*corrupt_once)(Bench&);
  };
  const Case cases[] = {
      {"wrong checksum", [](Bench& bench) { bench.hear(corrupted(wire::at_rest)); }},
      {"new start before the end",
       [](Bench& bench) {
         bench.hear(Bytes{0x60, 0xC0});
       }},
      {"3 ms of silence before the end",
       [](Bench& bench) {
         bench.hear(Bytes{0x60, 0xC0});
         bench.run_ms(4);
       }},
      {"framing error",
       [](Bench& bench) {
         bench.hear(Bytes{0x60, 0xC0});
         bench.hear_byte(0xC0, true);
         bench.hear(Bytes{0x80, 0x80, 0x80, 0x80, 0x80, 0x9F});
       }},
      {"too little data",
       [](Bench& bench) {
         bench.hear(Bytes{0x40, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0xBF});
       }},
      {"strays",
       [](Bench& bench) {
         bench.hear(Bytes{0x80, 0x80, 0x80});
         bench.run_ms(4);
       }},
  };
  for (const Case& one : cases) {
    CAPTURE(one.name);
    Bench bench = Bench::ready();
    one.corrupt_once(bench);
    one.corrupt_once(bench);
    CHECK_FALSE(bench.is_transient());
    one.corrupt_once(bench);
    bench.hear(Bytes{0x60});  // shows that a packet was cut off
    CHECK(bench.is_transient());
    CHECK(bench.is_limping());
  }
}

TEST_CASE("corruption is not counted before the first valid SR power-up packet, and is after it", "[SB-2.14]") {
  Bench silent;
  silent.hear(corrupted(wire::at_rest), 20);
  silent.run_ms(50);
  silent = Bench::ready(std::move(silent));
  CHECK_FALSE(silent.is_limping());
  CHECK(silent.spm().inhibits().empty());

  Bench greeted = Bench::greeted();
  greeted.hear(corrupted(wire::at_rest), 3);
  CHECK(greeted.is_transient());
  CHECK(greeted.is_limping());
}

TEST_CASE("the third corrupt packet trips even if a sound one follows within the same step", "[SB-2.14][H-05]") {
  Bench bench = Bench::ready();
  bench.hear(corrupted(wire::at_rest), 2);
  bench.hear(Bytes{0x60, 0xC0, 0xC0});
  // The loop was busy: the start that cuts the third packet off comes together with the rest of its own packet.
  for (std::uint8_t i = 0; i < 3; ++i) {
    bench.in.heard[i] = base::HeardByte{wire::unknown_type[i], false,
                                        base::Stamp(static_cast<std::uint16_t>(bench.now() + 286 * (i + 1)))};
  }
  bench.in.heard_count = 3;
  bench.run_ms(1);
  CHECK(bench.is_transient());
  CHECK(bench.is_limping());
}

TEST_CASE("a corrupt general moves nothing", "[SB-2.9][SB-2.13][H-01][H-06]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 100; ++i) {
    bench.cycle(corrupted(wire::forward_fast));
    bench.cycle(wire::at_rest);
  }
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
}

// ---- silence

TEST_CASE("without a valid general TRANSIENT and LIMP are raised 61 to 62 ms after the end of the last",
          "[SB-2.15][H-04]") {
  for (Microseconds phase = 0; phase < 2000; phase += 41) {
    Bench bench = Bench::driving();
    bench.run_us(phase);
    bench.hear(wire::forward_fast);
    const Microseconds end = bench.now();
    bench.hear(wire::tf);
    CAPTURE(phase);
    bench.run_until(end + 61000);
    REQUIRE_FALSE(bench.is_transient());
    REQUIRE(bench.left() == 16384);
    bench.run_until(end + 62000);
    REQUIRE(bench.is_transient());
    REQUIRE(bench.is_limping());
    CHECK(bench.has_event(spm::EventCode::general_missing));
  }
}

TEST_CASE("corrupt, foreign and too short packets do not break the silence", "[SB-2.15][SB-2.9][H-04]") {
  Bench bench = Bench::ready();
  const Microseconds end = bench.now() - 20000 + 9 * Bench::character;
  bench.hear(corrupted(wire::at_rest) + wire::unknown_type + Bytes{0x40, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0xBF} +
             Bytes{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4} + wire::tf);
  bench.run_until(end + 61000);
  CHECK_FALSE(bench.is_transient());
  bench.run_until(end + 62000);
  CHECK(bench.is_transient());
}

TEST_CASE("a remote that sends every 60 ms lives, one that sends every 66 ms trips", "[SB-2.15]") {
  Bench slow = Bench::ready();
  slow.cycle(wire::at_rest, 200, 60000);
  CHECK_FALSE(slow.is_limping());
  CHECK(slow.spm().inhibits().empty());
  Bench slower = Bench::ready();
  slower.cycle(wire::at_rest, 2, 66000);
  CHECK(slower.is_limping());
}

TEST_CASE("silence is not supervised before the first general", "[SB-2.15]") {
  Bench bench = Bench::greeted();
  bench.run_ms(1000);
  CHECK_FALSE(bench.is_limping());
  bench.cycle(wire::at_rest);
  bench.run_ms(62);
  CHECK(bench.is_limping());
}

TEST_CASE("the chair stops on its own when the bus falls silent: zero within 1500 ms, brakes 250 ms later",
          "[SB-2.17][SB-2.15][H-04][H-03]") {
  for (const Bytes& command : {wire::forward_fast, wire::reverse_fast, sr_general({512, 1023, 255}),
                               sr_general({1023, 0, 255}), wire::forward_slow}) {
    Bench bench = Bench::ready();
    bench.cycle(command, 400);
    REQUIRE_FALSE(bench.is_still());
    while (!bench.is_transient()) {
      bench.run_us(500);
    }
    bench.run_ms(1);
    const Microseconds trip = bench.now();
    int left = std::abs(bench.left());
    int right = std::abs(bench.right());
    while (!bench.is_still()) {
      bench.run_ms(1);
      REQUIRE((std::abs(bench.left()) < left || left == 0));
      REQUIRE((std::abs(bench.right()) < right || right == 0));
      left = std::abs(bench.left());
      right = std::abs(bench.right());
      REQUIRE(bench.now() - trip <= 1500000);
    }
    const Microseconds stop = bench.now();
    while (!bench.is_braked()) {
      bench.run_ms(1);
      REQUIRE(bench.now() - stop <= 250000);
    }
    bench.run_ms(1000);
    CHECK(bench.is_still());
    CHECK(bench.is_braked());
  }
}

TEST_CASE("an emergency stop runs to its end whatever the bus says meanwhile", "[SB-2.17][H-08][H-33]") {
  Bench bench = Bench::driving();
  bench.run_ms(70);
  REQUIRE(bench.is_transient());
  int before = bench.left();
  const Microseconds trip = bench.now();
  while (!bench.is_braked()) {
    bench.cycle(wire::forward_fast);
    REQUIRE(bench.left() <= before);
    before = bench.left();
    REQUIRE(bench.now() - trip <= 1780000);
  }
  bench.cycle(wire::forward_fast, 200);
  CHECK(bench.is_still());
  CHECK_FALSE(bench.is_transient());
  CHECK(bench.is_neutral_demanded());
}

TEST_CASE("a driver cannot cut an emergency stop short, even with neutral in between", "[SB-2.17][H-08]") {
  Bench bench = Bench::driving();
  bench.run_ms(70);
  REQUIRE(bench.is_transient());
  bench.cycle(wire::at_rest, 12);
  CHECK_FALSE(bench.is_transient());
  REQUIRE_FALSE(bench.is_still());
  int before = bench.left();
  while (!bench.is_braked()) {
    bench.cycle(wire::forward_fast);
    REQUIRE(bench.left() <= before);
    before = bench.left();
  }
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.is_still());  // neutral must come after the stop
  CHECK(bench.is_neutral_demanded());
  bench.cycle(wire::at_rest, 5);
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.left() > 0);
}

// ---- back again

TEST_CASE("five generals in a row clear TRANSIENT, four do not, and LIMP stays", "[SB-2.16][H-07][H-08]") {
  Bench bench = Bench::ready();
  bench.run_ms(70);
  REQUIRE(bench.is_transient());
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_transient());
  bench.cycle(wire::at_rest);
  CHECK_FALSE(bench.is_transient());
  CHECK(bench.is_limping());
  CHECK(bench.general_bit(0, 5));
  CHECK(bench.system_state() == 9);
}

TEST_CASE("a corrupt packet or a pause among the five starts them over", "[SB-2.16][H-06][H-08]") {
  Bench bench = Bench::ready();
  bench.run_ms(70);
  bench.cycle(wire::at_rest, 4);
  bench.cycle(corrupted(wire::at_rest));
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_transient());
  bench.run_ms(70);
  bench.cycle(wire::at_rest, 4);
  CHECK(bench.is_transient());
  bench.cycle(wire::at_rest);
  CHECK_FALSE(bench.is_transient());
}

TEST_CASE("after an emergency stop the chair drives again only after neutral, and only as far as LIMP lets it",
          "[SB-2.16][SB-2.17][SB-01.8][H-02][H-07][H-08]") {
  Bench bench = Bench::driving();
  bench.run_ms(2000);
  bench.cycle(wire::forward_fast, 50);  // the stick still held: TRANSIENT clears, nothing moves
  CHECK_FALSE(bench.is_transient());
  CHECK(bench.is_still());
  CHECK(bench.is_neutral_demanded());
  CHECK(bench.is_inhibit_shown());
  bench.cycle(wire::at_rest, 4);
  bench.cycle(wire::forward_fast, 50);
  CHECK(bench.is_still());
  bench.cycle(wire::at_rest, 5);
  CHECK_FALSE(bench.is_inhibit_shown());
  int most = 0;
  for (int i = 0; i < 400; ++i) {
    bench.cycle(wire::forward_fast);
    most = std::max(most, bench.left());
  }
  CHECK(most == Approx(6554).margin(1));
  CHECK(bench.is_limping());
}

TEST_CASE("no amount of stopping and starting ends LIMP", "[SB-2.16][H-07]") {
  Bench bench = Bench::ready();
  bench.run_ms(70);
  bench.cycle(wire::at_rest, 20);
  for (int i = 0; i < 40; ++i) {
    bench.cycle(wire::forward_fast, 50);
    bench.cycle(wire::at_rest, 50);
    REQUIRE(bench.is_limping());
    REQUIRE(bench.general_bit(0, 5));
  }
}

TEST_CASE("a chair that limps at pot 0 is as fast as ever", "[SB-2.16]") {
  Bench bench = Bench::ready();
  bench.run_ms(70);
  bench.cycle(wire::at_rest, 20);
  bench.cycle(wire::forward_slow, 150);
  CHECK(bench.left() == Approx(3604).margin(2));
}

TEST_CASE("corruption at rest makes no noise and no motion, and five generals later all but LIMP is well",
          "[SB-2.18]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.hear(Bytes(500, 0xAA));
  bench.hear(corrupted(wire::forward_fast), 20);
  CHECK(bench.turns().size() == before);
  CHECK(bench.is_still());
  bench.run_ms(10);
  bench.cycle(wire::at_rest, 10);
  CHECK_FALSE(bench.is_transient());
  CHECK(bench.is_limping());
}

}  // namespace
