#include "tests/simulation/board/bench.hpp"

namespace simulation {
namespace {

constexpr unsigned power_on = 0x01, external = 0x02, brown_out = 0x04, watchdog = 0x08;  // MCUSR

}  // namespace

TEST_CASE("every kind of reset tells its cause and keeps RAM") {
  struct Row {
    ResetKind kind;
    unsigned cause;
  };
  const auto row = GENERATE(Row{ResetKind::external, external}, Row{ResetKind::brown_out, brown_out},
                            Row{ResetKind::watchdog, watchdog});
  Bench bench("resets", {0});
  bench.start().run(10ms);
  CHECK(bench.byte("causes") == power_on);
  CHECK(bench.byte("starts") == 1);
  CHECK(bench.board->ram(0xC1) == 0);  // UCSR0B: a transmitter starts switched off
  bench.board->reset(row.kind, bench.now);
  bench.run(10ms);
  CHECK(bench.byte("causes") == row.cause);
  CHECK(bench.byte("starts") == 2);
  CHECK(bench.board->statistics().resets == 1);
}

TEST_CASE("causes of resets add up until the program clears them") {
  Bench bench("resets", {5});
  bench.start().run(10ms).board->reset(ResetKind::external, bench.now);
  bench.run(10ms);
  CHECK(bench.byte("causes") == (power_on | external));
}

TEST_CASE("outputs fall at a reset, inputs and timers come back") {
  Bench bench("resets", {0});
  bench.wake(true).start().run(50ms);
  CHECK(bench.board->pins().power_latch);
  CHECK(bench.word("ticks") >= 48);
  bench.board->reset(ResetKind::external, bench.now);
  CHECK_FALSE(bench.board->pins().power_latch);
  bench.run(50ms);
  CHECK(bench.board->pins().power_latch);
  CHECK(bench.word("ticks") >= 48);
  CHECK(bench.word("ticks") <= 50);
  CHECK((bench.board->ram(0x23) & 0x04U) != 0);  // PINB: WAKE is still high
}

TEST_CASE("a program that does not feed the watchdog starts again") {
  Bench bench("resets", {1});
  bench.start().run(125ms);
  CHECK(bench.byte("starts") == 1);
  bench.run(20ms);  // 100 ms, and 32 ms later the bite
  CHECK(bench.byte("starts") == 2);
  CHECK(bench.byte("causes") == watchdog);
  CHECK(bench.board->statistics().resets == 1);
  CHECK(bench.board->statistics().complaints.empty());
  const Time limit = bench.now + 999'900us;
  CHECK(bench.board->run_until(limit) - limit < 2us);
  CHECK(bench.board->statistics().resets == 8);
}

TEST_CASE("a program gone wild is reported, stays frozen and is ended by the watchdog") {
  struct Row {
    std::uint8_t choice;
    const char* complaint;
  };
  const auto row =
      GENERATE(Row{2, "Invalid write address"}, Row{3, "SLEEP with interrupts off"}, Row{4, "left the image"});
  Bench bench("resets", {row.choice});
  bench.start().run(120ms);
  CHECK(bench.byte("starts") == 1);
  CHECK(bench.board->pins().power_latch);
  const auto complaints = bench.board->statistics().complaints;
  REQUIRE_FALSE(complaints.empty());
  CHECK_THAT(complaints.front(), Catch::Matchers::Contains(row.complaint));
  bench.run(25ms);
  CHECK(bench.board->statistics().resets == 1);
}

TEST_CASE("without power nothing runs, and power-on starts afresh") {
  Bench bench("resets", {0});
  CHECK(bench.board->run_until(10ms) == 10ms);
  CHECK_FALSE(bench.board->is_powered());
  bench.start().run(20ms);
  CHECK(bench.board->is_powered());
  const std::uint64_t cycles = bench.board->statistics().cycles;
  bench.board->power(false, bench.now);
  CHECK(bench.board->pins() == Pins{});
  bench.run(1s);
  CHECK(bench.board->statistics().cycles == cycles);
  bench.board->hear({0x55, false, bench.now});
  bench.board->reset(ResetKind::external, bench.now);
  bench.start().run(20ms);
  CHECK(bench.byte("starts") == 1);
  CHECK(bench.byte("causes") == power_on);
  CHECK(bench.board->statistics().cycles - cycles >= 160'000);
}

TEST_CASE("two chips in one process do not disturb each other") {
  Bench one("resets", {1});
  Bench two("resets", {0});
  one.start();
  two.start();
  for (int i = 0; i < 200; ++i) {
    one.run(1ms);
    two.run(1ms);
  }
  CHECK(one.byte("starts") == 2);
  CHECK(two.byte("starts") == 1);
  CHECK(two.board->statistics().resets == 0);
}

}  // namespace simulation
