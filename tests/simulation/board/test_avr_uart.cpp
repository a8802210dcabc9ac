#include "tests/simulation/board/bench.hpp"

namespace simulation {
namespace {

// One bit is 16 * (12 + 1) = 208 cycles of 125 ns = 26 us.
constexpr Time bit = 26us;

std::vector<Time> distances(const std::vector<Spoken>& spoken) {
  std::vector<Time> all;
  for (std::size_t i = 1; i < spoken.size(); ++i) {
    all.push_back(spoken[i].start - spoken[i - 1].start);
  }
  return all;
}

}  // namespace

TEST_CASE("a character lasts as many bits as its frame has, back to back and whatever was written first") {
  struct Row {
    std::uint8_t choice;
    Time frame;
  };
  const auto row = GENERATE(Row{0, 11 * bit},   // 8N2, baud rate written first: 2288 cycles
                            Row{1, 11 * bit},   // 8N2, baud rate written last
                            Row{2, 10 * bit},   // 8N1
                            Row{3, 12 * bit},   // 8E2
                            Row{4, 11 * bit});  // 8N2 at double speed
  CAPTURE(int{row.choice});
  Bench bench("uart_send", {row.choice});
  bench.start().run(5ms);
  REQUIRE(bench.spoken.size() == 5);
  CHECK(bench.spoken[0].value == 0x10);
  CHECK(bench.spoken[4].value == 0x14);
  // The first character is caught by the second in the buffer: no gap anywhere.
  CHECK(distances(bench.spoken) == std::vector<Time>(4, row.frame));
  CHECK(bench.board->bit_time() == bit);
  CHECK(bench.byte("complete") == 1);
  CHECK(bench.board->statistics().complaints.empty());
}

TEST_CASE("a crystal that runs fast makes shorter characters") {
  Bench bench("uart_send", {0}, 10'000);
  bench.start().run(5ms);
  REQUIRE(bench.spoken.size() == 5);
  // 2288 cycles at 8.08 MHz are 283.168 us.
  for (const Time distance : distances(bench.spoken)) {
    CHECK(std::chrono::abs(distance - 283'168ns) <= 1ns);
  }
  CHECK(bench.board->bit_time() == 25'742ns);
}

TEST_CASE("a burst by interrupts has no gaps and completes once") {
  Bench bench("uart_burst");
  bench.start().run(1ms).wake(true).run(5ms);
  REQUIRE(bench.spoken.size() == 10);
  CHECK(distances(bench.spoken) == std::vector<Time>(9, 286us));
  CHECK(bench.byte("empty") == 11);
  CHECK(bench.byte("complete") == 1);
  bench.wake(false).run(1ms).wake(true).run(5ms);
  CHECK(bench.spoken.size() == 20);
  CHECK(bench.byte("complete") == 2);
}

TEST_CASE("running comes back right after a start bit, so that the world can react") {
  Bench bench("uart_burst");
  bench.start().run(1ms).wake(true);
  const Time reached = bench.board->run_until(10ms);
  REQUIRE(bench.spoken.size() == 1);
  CHECK(reached >= bench.spoken[0].start);
  CHECK(reached - bench.spoken[0].start < 2us);
  const Time again = bench.board->run_until(10ms);
  REQUIRE(bench.spoken.size() == 2);
  CHECK(again - bench.spoken[1].start < 2us);
}

TEST_CASE("time goes on from the moment of power-on") {
  Bench bench("uart_send");
  bench.run(100ms).start().run(5ms);
  REQUIRE(bench.spoken.size() == 5);
  CHECK(bench.spoken[0].start > 100ms);
  CHECK(bench.spoken[0].start < 101ms);
  bench.board->power(false, bench.now);
  bench.run(1s).start().run(5ms);
  REQUIRE(bench.spoken.size() == 10);
  CHECK(bench.spoken[5].start - bench.spoken[0].start == bench.now - 5ms - 100ms);
}

TEST_CASE("two runs speak at the same nanosecond") {
  const auto story = [] {
    Bench bench("uart_burst");
    for (int i = 0; i < 5; ++i) {
      bench.wake(false).start().run(1'234'567ns).wake(true).run(4ms);
    }
    return bench.spoken;
  };
  const auto once = story();
  CHECK(once.size() == 50);
  CHECK(story() == once);
}

TEST_CASE("the receiver keeps three characters of ten and tells of the loss with the next one") {
  Bench bench("uart_receive");
  bench.start().run(5ms);
  for (std::uint8_t i = 0; i < 10; ++i) {
    bench.run(286us).hear(static_cast<std::uint8_t>(0xA0 + i));
  }
  bench.wake(true).run(1ms);
  CHECK(bench.byte("count") == 3);
  CHECK(bench.byte("values", 0) == 0xA0);
  CHECK(bench.byte("values", 2) == 0xA2);
  CHECK(bench.board->statistics().overruns == 7);
  bench.hear(0xC5);
  bench.run(286us).hear(0xC6);
  bench.run(286us);
  REQUIRE(bench.byte("count") == 5);
  CHECK(bench.byte("values", 3) == 0xC5);
  constexpr unsigned data_overrun = 0x08;
  CHECK((bench.byte("states", 2) & data_overrun) == 0);
  CHECK((bench.byte("states", 3) & data_overrun) != 0);
  CHECK((bench.byte("states", 4) & data_overrun) == 0);
}

TEST_CASE("a framing error comes with its own character only") {
  Bench bench("uart_receive");
  bench.start().run(5ms).hear(0x11);
  bench.run(286us).hear(0x00, true);
  bench.run(286us).hear(0x33);
  bench.wake(true).run(1ms);
  REQUIRE(bench.byte("count") == 3);
  constexpr unsigned frame_error = 0x10;
  CHECK((bench.byte("states", 0) & frame_error) == 0);
  CHECK((bench.byte("states", 1) & frame_error) != 0);
  CHECK((bench.byte("states", 2) & frame_error) == 0);
}

TEST_CASE("the receive interrupt is a level: characters that waited are served one by one") {
  Bench bench("uart_receive", {1});
  bench.start().run(5ms).hear(0x55);
  bench.run(20us);
  CHECK(bench.byte("count") == 1);
  bench.wake(true).run(1ms);  // deaf from here on
  for (std::uint8_t i = 0; i < 3; ++i) {
    bench.hear(i);
    bench.run(286us);
  }
  CHECK(bench.byte("count") == 1);
  bench.wake(false).run(50us);
  CHECK(bench.byte("count") == 4);
  CHECK(bench.byte("values", 3) == 2);
  CHECK(bench.board->statistics().overruns == 0);
}

TEST_CASE("a receiver that is off hears nothing") {
  Bench bench("uart_send");
  bench.start().run(5ms).hear(0x55);
  bench.run(1ms);
  CHECK(bench.board->statistics().overruns == 0);
  CHECK(bench.board->ram(0xC0) == 0x20);  // UCSR0A: the transmitter is empty, nothing was received
}

}  // namespace simulation
