// The power module against time: the wrap of its clocks, a loop that is held up, a bus that never rests, wake while
// running, and two of them side by side.
#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

constexpr std::uint32_t before_wrap = 0xFFFFFFFF - 99;  // 100 ms before the 32-bit milliseconds start over

// Everything a module does in a life: handshake, drive, lost link, recovery, drive, power-down.
struct Life {
  std::vector<Bytes> turns;
  std::vector<int> demands;  // left and right, every 20 ms
  std::size_t steps_to_off = 0;
};

Life live(Bench bench) {
  Life life;
  const auto cycle = [&](const Bytes& packets, int times) {
    for (int i = 0; i < times; ++i) {
      bench.cycle(packets);
      life.demands.push_back(bench.left());
      life.demands.push_back(bench.right());
    }
  };
  cycle(wire::sr_power_up, 1);
  cycle(wire::at_rest, 10);
  cycle(sr_general({1022, 600, 200}), 100);
  bench.run_ms(500);
  cycle(wire::at_rest, 60);
  cycle(wire::reverse_fast, 100);
  cycle(wire::at_rest, 100);
  cycle(wire::button_down, 5);
  cycle(wire::at_rest, 2);
  while (!bench.is_off() && life.steps_to_off < 10000) {
    bench.run_ms(1);
    ++life.steps_to_off;
  }
  for (const Spoken& turn : bench.turns()) {
    life.turns.push_back(turn.bytes);
  }
  return life;
}

TEST_CASE("the wrap of the millisecond clock makes no difference, wherever in the module's life it falls",
          "[SB-2.15][SB-4.4]") {
  const Life normal = live(Bench(1000));
  CHECK(normal.steps_to_off == Approx(500).margin(25));
  for (const std::uint32_t start :
       {before_wrap, 0xFFFFFFFF - 1000, 0xFFFFFFFF - 2300, 0xFFFFFFFF - 3100, 0xFFFFFFFF - 7000, 0xFFFFFFFF - 8300}) {
    const Life wrapped = live(Bench(start));
    CAPTURE(start);
    CHECK(wrapped.turns == normal.turns);
    CHECK(wrapped.demands == normal.demands);
    CHECK(wrapped.steps_to_off == normal.steps_to_off);
  }
}

TEST_CASE("a lost link is noticed across the wrap as everywhere else", "[SB-2.15][H-04]") {
  for (std::uint32_t early = 0; early < 130; early += 3) {
    Bench bench = Bench::greeted(Bench(0xFFFFFFFF - 120 - early));
    bench.hear(wire::at_rest);
    const Microseconds end = bench.now();
    bench.hear(wire::tf);
    bench.run_until(end + 61000);
    REQUIRE_FALSE(bench.is_transient());
    bench.run_until(end + 62000);
    REQUIRE(bench.is_transient());
  }
}

TEST_CASE("two modules in one process know nothing of each other") {
  const Life alone = live(Bench(1000));
  Bench driving = Bench::driving();
  Bench silent;
  Bench limping = Bench::ready();
  limping.run_ms(70);
  for (int i = 0; i < 100; ++i) {
    driving.cycle(wire::forward_fast);
    silent.cycle(Bytes{});
    limping.cycle(wire::at_rest);
  }
  CHECK(driving.left() == 16384);
  CHECK_FALSE(driving.is_limping());
  CHECK(silent.turns().empty());
  CHECK(silent.is_still());
  CHECK(limping.is_limping());
  CHECK(limping.is_still());
  const Life again = live(Bench(1000));
  CHECK(again.turns == alone.turns);
  CHECK(again.demands == alone.demands);
}

TEST_CASE("the same inputs give the same outputs, and a copy goes on like its original") {
  Bench original = Bench::driving();
  Bench copy = original;
  for (int i = 0; i < 100; ++i) {
    original.cycle(i < 50 ? wire::reverse_fast : wire::joystick_error);
    copy.cycle(i < 50 ? wire::reverse_fast : wire::joystick_error);
    REQUIRE(original.left() == copy.left());
    REQUIRE(original.last_turn() == copy.last_turn());
  }
}

// ---- a loop that is held up

TEST_CASE("a loop held up for seconds loses the link and makes no jump", "[H-23][H-33][SB-2.15]") {
  spm::Spm module;
  spm::Inputs in;
  in.battery = base::Millivolts(24000);
  in.analog_ready = true;
  std::uint32_t now = 0;
  const auto step = [&](const Bytes& bytes) {
    spm::Outputs out;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      in.heard[0] = base::HeardByte{bytes[i], false, base::Stamp(static_cast<std::uint16_t>(now * 1000))};
      in.heard_count = 1;
      in.stamp = base::Stamp(static_cast<std::uint16_t>(now * 1000));
      out = module.step(in, base::Instant(now));
    }
    in.heard_count = 0;
    for (int i = 0; i < 20; ++i) {
      ++now;
      in.stamp = base::Stamp(static_cast<std::uint16_t>(now * 1000));
      in.brake_coils = base::Milliamps(out.left_brake == spm::Brake::released ? 1300 : 0);
      out = module.step(in, base::Instant(now));
    }
    return out;
  };
  step(wire::sr_power_up);
  for (int i = 0; i < 10; ++i) {
    step(wire::at_rest);
  }
  spm::Outputs driving;
  for (int i = 0; i < 100; ++i) {
    driving = step(wire::forward_fast);
  }
  REQUIRE(driving.left.count() > 2000);
  now += 3000;
  in.stamp = base::Stamp(static_cast<std::uint16_t>(now * 1000));
  const spm::Outputs after = module.step(in, base::Instant(now));
  CHECK(module.faults().is_transient);
  CHECK(after.left.count() < driving.left.count());
  CHECK(driving.left.count() - after.left.count() <= 5 * 14);
  const spm::Outputs rest = step(Bytes{});
  CHECK(rest.left.count() < after.left.count());
  bool is_logged = false;
  for (std::uint8_t back = 0; back < 4; ++back) {
    const faults::Event event = module.events().newest(back);
    is_logged =
        is_logged || (event.code == static_cast<std::uint8_t>(spm::EventCode::time_was_lost) && event.argument == 255);
  }
  CHECK(is_logged);
}

// ---- a bus that never rests

TEST_CASE("a bus that babbles without a pause stops the chair as fast as a silent one", "[H-23][H-04][SB-2.17]") {
  const Bytes babbles[] = {
      {0x00},                    // a start byte of the shortest packet, over and over
      {0x02, 0x80},              // packets cut off before their checksum
      {0x60, 0xC0, 0xC0, 0x80},  // longer ones
      {0x05, 0x80, 0xFA},        // sound, but not for us
      {0x0B, 0x80, 0xF4},        // sound, unknown
      {0x0F},                    // TF
      {0xAA},                    // strays
  };
  for (const Bytes& babble : babbles) {
    Bench bench = Bench::driving();
    const Microseconds begin = bench.now();
    CAPTURE(int(babble[0]), babble.size());
    while (bench.now() - begin < 70000) {
      bench.hear(babble);
    }
    CHECK(bench.is_transient());
    CHECK(bench.left() < 16384);
    while (bench.now() - begin < 62000 + 1500000) {
      bench.hear(babble);
    }
    CHECK(bench.is_still());
    while (bench.now() - begin < 62000 + 1500000 + 250000) {
      bench.hear(babble);
    }
    CHECK(bench.is_braked());
  }
}

TEST_CASE("minutes of noise neither move a chair at rest nor make it speak", "[H-06][H-23][H-30][H-01]") {
  std::uint32_t seed = 7;
  Bench bench = Bench::greeted();
  const std::size_t before = bench.turns().size();
  for (int i = 0; i < 400000; ++i) {
    seed = seed * 1664525U + 1013904223U;
    bench.hear_byte(static_cast<std::uint8_t>(seed >> 24), (seed >> 10) % 64 == 0);
    REQUIRE(bench.is_still());
    REQUIRE(bench.is_braked());
  }
  CHECK(bench.turns().size() <= before + 2);  // the checksum is weak: a rare packet may look sound (H-06)
}

TEST_CASE("the step that has an answer to give leaves a millisecond's work for later, but for 2 ms at most", "[H-23]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::forward_fast, 50);
  bench.run_us(562);  // a millisecond begins 100 us before the checksum comes
  bench.hear(Bytes(wire::forward_fast.begin(), wire::forward_fast.end() - 1));
  const int before = bench.left();
  bench.hear_byte(wire::forward_fast.back());
  CHECK(bench.outputs().speech == spm::Speech::arm);
  CHECK(bench.left() == before);
  bench.run_us(500);
  CHECK(bench.left() > before);

  Bench busy = Bench::driving();
  busy.hear(wire::at_rest + Bytes{0x02, 0x80});  // a packet that never gets its checksum
  const int cruising = busy.left();
  busy.run_ms(3);
  CHECK(busy.left() < cruising);
}

// ---- wake while running

TEST_CASE("what is heard while wake is asserted is neither a packet nor a corrupt one", "[SB-1.3]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.in.wake = true;
  bench.hear(corrupted(wire::at_rest), 2);
  bench.hear(wire::at_rest + wire::tf);
  bench.run_ms(5);
  bench.in.wake = false;
  bench.run_ms(5);
  CHECK(bench.turns().size() == before);
  bench.hear(corrupted(wire::at_rest), 2);
  CHECK_FALSE(bench.is_transient());
  bench.cycle(wire::at_rest);
  CHECK(bench.turns().size() == before + 1);
}

TEST_CASE("a packet that wake broke off is not a corrupt one", "[SB-1.3]") {
  Bench bench = Bench::ready();
  bench.hear(corrupted(wire::at_rest), 2);
  bench.hear(Bytes{0x60, 0xC0, 0xC0});
  bench.in.wake = true;
  bench.run_ms(5);
  bench.in.wake = false;
  bench.run_ms(5);
  CHECK_FALSE(bench.is_transient());
}

TEST_CASE("an answer that waited when wake came is not given after it", "[SB-1.3][H-30]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.hear(wire::at_rest);
  bench.in.wake = true;
  bench.run_ms(1);
  bench.in.wake = false;
  bench.hear(wire::tf);
  bench.run_ms(10);
  CHECK(bench.turns().size() == before);
}

TEST_CASE("wake asserted while driving stops the chair like a silent bus", "[H-34][SB-1.3][SB-2.15][SB-2.17]") {
  Bench bench = Bench::driving();
  bench.hear(wire::forward_fast);
  const Microseconds end = bench.now();
  bench.in.wake = true;
  bench.run_until(end + 62000);
  CHECK(bench.is_transient());
  for (int i = 0; i < 10; ++i) {
    const int before = bench.left();
    bench.run_ms(1);
    CHECK(bench.left() < before);
  }
  bench.run_until(end + 62000 + 1500000);
  CHECK(bench.is_still());
  bench.run_ms(250);
  CHECK(bench.is_braked());
  CHECK_FALSE(bench.has_event(spm::EventCode::time_was_lost));
}

TEST_CASE("a line held dominant stops the chair like a silent one", "[H-34][SB-2.10][SB-2.15]") {
  Bench bench = Bench::driving();
  const Microseconds begin = bench.now();
  while (bench.now() - begin < 70000) {
    bench.hear_byte(0x00, true);
  }
  CHECK(bench.is_transient());
  CHECK(bench.left() < 16384);
}

}  // namespace
