#include "simulation/board/host_board.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

const Bytes sr_power_up{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1, 0x0F};
// Neutral, with TF.
const Bytes sr_general{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F};

constexpr Time character = 286us;
constexpr Time to_sampling = 250'250ns;  // 9.625 bits of 26 us

// The board on a line without anybody else: it hears what the test says and its own echo.
struct Bench {
  Bench() : board(make_host_board()) {
    board->on_speak([this](std::uint8_t value, Time start) {
      spoken.push_back(value);
      starts.push_back(start);
      echo = Reception{echo_of(value), false, start + to_sampling};
    });
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  std::uint8_t echo_of(std::uint8_t value) const { return spoken.size() == spoiled_echo ? 0x81 : value; }

  void run(Time until) {
    while (now < until) {
      const Time next = echo ? std::min(until, echo->at) : until;
      now = board->run_until(next);
      if (echo && echo->at <= now) {
        const Reception own = *echo;
        echo.reset();
        board->hear(own);
      }
    }
  }
  void say(const Bytes& bytes, Time from) {
    for (const std::uint8_t byte : bytes) {
      run(from + to_sampling);
      board->hear({byte, false, from + to_sampling});
      last_heard = from + to_sampling;
      from += character;
    }
  }
  // Powered early enough that the firmware runs from now on.
  void power_up() {
    board->power(true, now - host_start_up - 2ms);
    run(now);
  }
  void bring_up() {
    power_up();
    say(sr_power_up, now + 10ms);
    run(now + 10ms);
  }

  std::unique_ptr<SpmBoard> board;
  Time now{};
  Time last_heard{};
  std::optional<Reception> echo;
  Bytes spoken;
  std::vector<Time> starts;
  std::size_t spoiled_echo = 0;  // of which character; 0 = none
};

}  // namespace

TEST_CASE("An unpowered host board does nothing and has all pins low") {
  const auto board = make_host_board();
  CHECK(board->name() == "host");
  CHECK_FALSE(board->is_powered());
  CHECK(board->pins() == Pins{});
  CHECK(board->run_until(1s) == 1s);
  board->reset(ResetKind::watchdog, 1s);
  CHECK(board->statistics().resets == 0);
}

TEST_CASE("The host board holds its latch from reset on, everything else rests", "[SB-1.2]") {
  const auto board = make_host_board();
  board->power(true, 5ms);
  Pins latch_only;
  latch_only.power_latch = true;
  latch_only.left_forward = latch_only.right_forward = board->pins().left_forward;
  CHECK(board->pins() == latch_only);
  board->power(false, 6ms);
  CHECK(board->pins() == Pins{});
}

TEST_CASE("The host board answers a power-up packet 59 us after TF was received, back to back",
          "[SB-3.2][SB-05.1][SB-2.7]") {
  Bench bench;
  bench.bring_up();
  REQUIRE(bench.spoken == Bytes{0x05, 0x80, 0xFA, 0x0F});
  CHECK(bench.starts[0] - bench.last_heard == 59us);
  CHECK(bench.starts[1] - bench.starts[0] == 286us);
  CHECK(bench.starts[3] - bench.starts[0] == 858us);
}

TEST_CASE("A turn without TF is answered 3 to 3.5 ms after its last byte", "[SB-2.12]") {
  Bench bench;
  bench.power_up();
  bench.say({0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1}, 10ms);
  bench.run(30ms);
  REQUIRE(bench.spoken == Bytes{0x05, 0x80, 0xFA, 0x0F});
  CHECK(bench.starts[0] - bench.last_heard >= 3ms);
  CHECK(bench.starts[0] - bench.last_heard <= 3523us);
}

TEST_CASE("run_until comes back at the begin of each character") {
  Bench bench;
  bench.power_up();
  bench.say(sr_power_up, 10ms);
  const Time first = bench.last_heard + 59us;
  for (int i = 0; i < 4; ++i) {
    CHECK(bench.board->run_until(50ms) == first + i * character);
  }
  CHECK(bench.board->run_until(50ms) == 50ms);
}

TEST_CASE("The host board does not take its echo for a packet", "[SB-1.4]") {
  Bench bench;
  bench.bring_up();
  bench.say(sr_general, 40ms);
  bench.run(60ms);
  REQUIRE(bench.spoken.size() == 18);  // power-up, then general and settings
  CHECK(bench.spoken[4] == 0x61);
  CHECK(bench.spoken[13] == 0x1A);
  CHECK(bench.spoken.back() == 0x0F);
}

TEST_CASE("An echo that differs ends the turn after the character in the buffer", "[SB-1.4]") {
  Bench bench;
  bench.bring_up();
  bench.spoken.clear();
  bench.spoiled_echo = 3;
  bench.say(sr_general, 40ms);
  bench.run(60ms);
  CHECK(bench.spoken.size() == 4);
  bench.spoken.clear();
  bench.spoiled_echo = 0;
  bench.say(sr_general, 60ms);
  bench.run(80ms);
  CHECK(bench.spoken.size() >= 10);
}

TEST_CASE("Wake silences the host board", "[SB-1.3]") {
  Bench bench;
  bench.bring_up();
  bench.spoken.clear();
  bench.say({0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC}, 40ms);
  Surroundings surroundings;
  surroundings.wake = true;
  bench.board->surround(surroundings);
  bench.run(bench.now + 1ms);
  surroundings.wake = false;
  bench.board->surround(surroundings);
  bench.say({0x0F}, bench.now + 1ms);
  bench.run(60ms);
  CHECK(bench.spoken.empty());
}

TEST_CASE("A reset lets the pins fall, counts, and forgets the handshake", "[SB-3.9][SB-3.1]") {
  Bench bench;
  bench.bring_up();
  bench.board->reset(ResetKind::watchdog, bench.now);
  CHECK(bench.board->statistics().resets == 1);
  CHECK(bench.board->pins().power_latch);
  CHECK_FALSE(bench.board->pins().motor_relay);
  bench.run(bench.now + host_start_up);
  bench.spoken.clear();
  bench.say(sr_general, bench.now + 5ms);
  bench.run(bench.now + 20ms);
  CHECK(bench.spoken.empty());
  bench.say(sr_power_up, bench.now + 5ms);
  bench.run(bench.now + 20ms);
  CHECK(bench.spoken == Bytes{0x05, 0x80, 0xFA, 0x0F});

  bench.board->power(false, bench.now);
  bench.board->power(true, bench.now + 1s);
  CHECK(bench.board->statistics().resets == 0);
}

TEST_CASE("The EEPROM outlives resets and the supply") {
  const auto board = make_host_board();
  CHECK(board->eeprom() == Bytes(4096, 0xFF));
  board->set_eeprom({1, 2, 3});
  board->power(true, 0ms);
  board->reset(ResetKind::external, 1ms);
  board->power(false, 2ms);
  board->power(true, 3ms);
  const Bytes contents = board->eeprom();
  CHECK(Bytes(contents.begin() + 1, contents.begin() + 4) == Bytes{2, 3, 0xFF});
}

TEST_CASE("Two host boards in one process do not know each other") {
  Bench one;
  Bench other;
  other.power_up();
  one.bring_up();
  other.run(one.now);
  CHECK(one.spoken.size() == 4);
  CHECK(other.spoken.empty());
  CHECK(other.board->pins().power_latch);
}
