#include "simulation/wire.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

constexpr Time bit{26'042};
constexpr Time character = 11 * bit;
constexpr CharacterFormat spike{1us};  // as the start bit of an FF, and nothing after it

// A general of the remote in neutral with its TF, and its power-up packet.
const Bytes general{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F};
const Bytes power_up{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1, 0x0F};

struct Ear final : WireNode {
  Time clock = bit;
  std::vector<Reception> heard;

  Time bit_time() const override { return clock; }
  void hear(const Reception& reception) override { heard.push_back(reception); }
  Bytes values() const {
    Bytes values;
    for (const Reception& reception : heard) {
      values.push_back(reception.value);
    }
    return values;
  }
  bool has_framing_error() const {
    return std::any_of(heard.begin(), heard.end(), [](const Reception& r) { return r.framing_error; });
  }
};

struct Bench {
  explicit Bench(std::uint64_t seed = 1) : wire(seed) {
    wire.attach(WireEnd::remote, remote);
    wire.attach(WireEnd::power_module, module);
    wire.on_byte([this](const BusByte& byte) { log.push_back(byte); });
    wire.on_wake([this](bool asserted, Time at) { wakes.emplace_back(asserted, at); });
  }
  Bench& run(Time until) {
    wire.advance(until);
    return *this;
  }
  void send(Sender sender, const Bytes& values, Time start, const CharacterFormat& format) {
    for (const std::uint8_t value : values) {
      wire.send(sender, value, start, format);
      start += format.length();
    }
  }
  Bytes logged() const {
    Bytes values;
    for (const BusByte& byte : log) {
      values.push_back(byte.heard);
    }
    return values;
  }

  Ear remote;
  Ear module;
  Wire wire;
  std::vector<BusByte> log;
  std::vector<std::pair<bool, Time>> wakes;
};

Bytes all_values() {
  Bytes values;
  for (int value = 0; value < 256; ++value) {
    values.push_back(static_cast<std::uint8_t>(value));
  }
  return values;
}

}  // namespace

TEST_CASE("Everybody hears a character at its first stop bit, its sender too", "[SB-1.4][SB-2.1]") {
  Bench bench;
  bench.module.clock = 26us;
  bench.wire.send(Sender::spm, 0x61, 1ms);
  CHECK(bench.wire.next_time() == 1ms + 250'250ns);  // 9.625 bits of 26 us
  bench.run(1ms + 250'249ns);
  CHECK(bench.module.heard.empty());
  bench.run(2ms);
  CHECK(bench.wire.next_time() == Time::max());
  REQUIRE(bench.module.values() == Bytes{0x61});
  CHECK(bench.module.heard[0].at == 1ms + 250'250ns);
  REQUIRE(bench.remote.values() == Bytes{0x61});
  CHECK(bench.remote.heard[0].at == 1ms + 250'654ns);
  CHECK_FALSE(bench.remote.has_framing_error());
}

TEST_CASE("The observer is told of each character once, with sender, begin and end") {
  Bench bench;
  bench.wire.send(Sender::sr, {0x60, 0xC0}, 1ms);
  bench.run(1ms + character);
  REQUIRE(bench.log.size() == 1);
  CHECK(bench.log[0].sender == Sender::sr);
  CHECK(bench.log[0].start == 1ms);
  CHECK(bench.log[0].end == 1ms + character);
  CHECK(bench.log[0].sent == 0x60);
  CHECK(bench.log[0].heard == 0x60);
  CHECK_FALSE(bench.log[0].spoiled);
  CHECK_FALSE(bench.log[0].lost);
  bench.run(5ms);
  CHECK(bench.logged() == Bytes{0x60, 0xC0});
}

TEST_CASE("A turn announced ahead lets others speak before and between") {
  Bench bench;
  bench.wire.send(Sender::sr, 0x60, 1ms);
  bench.wire.send(Sender::sr, 0xC0, 2ms);
  bench.run(1ms);
  bench.wire.send(Sender::spm, 0x61, 1500us);
  bench.run(3ms);
  CHECK(bench.module.values() == Bytes{0x60, 0x61, 0xC0});
  CHECK(bench.logged() == Bytes{0x60, 0x61, 0xC0});
}

TEST_CASE("Who speaks before a turn that was announced is heard before it") {
  Bench bench;
  bench.wire.send(Sender::sr, 0x60, 2ms);
  bench.wire.send(Sender::spm, 0x61, 1ms);
  bench.run(3ms);
  CHECK(bench.module.values() == Bytes{0x61, 0x60});
  CHECK(bench.logged() == Bytes{0x61, 0x60});
}

TEST_CASE("A peer with one stop bit is heard back to back", "[SB-2.1]") {
  Bench bench;
  bench.send(Sender::sr, all_values(), 0ms, {bit, 1});
  bench.run(100ms);
  CHECK(bench.module.values() == all_values());
  CHECK_FALSE(bench.module.has_framing_error());
  CHECK(bench.log[0].end == 10 * bit);
}

TEST_CASE("Peers up to 2 % off are understood whatever they say", "[SB-2.1]") {
  const double error = GENERATE(-0.025, -0.02, -0.017, 0.017, 0.02, 0.025);
  const int stop_bits = GENERATE(1, 2);
  Bench bench;
  bench.module.clock = 26us;
  bench.send(Sender::sr, all_values(), 0ms, {Time(static_cast<int>(26'000 * (1 + error))), stop_bits});
  bench.run(100ms);
  CHECK(bench.module.values() == all_values());
  CHECK_FALSE(bench.module.has_framing_error());
}

TEST_CASE("A peer 6 % too fast has its stop bit taken for the last data bit") {
  Bench bench;
  bench.send(Sender::sr, {0x0F}, 0ms, {bit * 100 / 106, 2});
  bench.run(1ms);
  CHECK(bench.module.values() == Bytes{0x8F});
  CHECK(bench.logged() == Bytes{0x8F});
}

TEST_CASE("A peer 6 % too slow has its last data bit taken for the stop bit") {
  Bench bench;
  bench.send(Sender::sr, {0x0F}, 0ms, {bit * 100 / 94, 2});
  bench.run(1ms);
  REQUIRE(bench.module.heard.size() == 1);
  CHECK(bench.module.heard[0].framing_error);
  CHECK(bench.log[0].spoiled);
}

TEST_CASE("Who speaks at the same time hears the zeros of both", "[SB-2.18]") {
  Bench bench;
  bench.wire.send(Sender::spm, 0x61, 1ms);
  bench.wire.send(Sender::sr, 0x5C, 1ms + 500ns);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0x40});
  CHECK(bench.remote.values() == Bytes{0x40});
  CHECK(bench.logged() == Bytes{0x40, 0x40});
}

TEST_CASE("A late collision spoils the rest of the character", "[SB-2.18]") {
  Bench bench;
  bench.wire.send(Sender::sr, 0xFF, 1ms);
  bench.wire.send(Sender::noise, 0xFF, 1ms + 3 * bit);  // its start bit falls on bit 2
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0xFB});
  CHECK(bench.logged() == Bytes{0xFB, 0xFF});
}

TEST_CASE("A collision that pulls the stop bit down is a framing error, and the next edge is found inside") {
  Bench bench;
  bench.wire.send(Sender::sr, 0xFF, 1ms);
  bench.wire.send(Sender::noise, 0x54, 1ms + 8 * bit + bit / 2);
  bench.run(3ms);
  REQUIRE(bench.module.heard.size() == 2);
  CHECK(bench.module.heard[0].framing_error);
  CHECK(bench.module.heard[0].value == 0x7F);
  CHECK(bench.module.heard[1].value == 0xF5);  // 0x54 from its first falling edge on, after bit 2
  CHECK_FALSE(bench.module.heard[1].framing_error);
}

TEST_CASE("A spike is no character, and does not keep the next one from being heard") {
  Bench bench;
  bench.wire.send(Sender::noise, 0xFF, 1ms, spike);
  bench.wire.send(Sender::sr, 0x60, 1ms + 100us);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0x60});
}

TEST_CASE("A spike at one of the three votes of a bit is outvoted, two are not") {
  const bool has_second = GENERATE(false, true);
  Bench bench;
  const Time bit_3 = 1ms + 4 * bit;
  bench.wire.send(Sender::sr, 0xFF, 1ms);
  bench.wire.send(Sender::noise, 0xFF, bit_3 + bit * 8 / 16 - spike.bit / 2, spike);
  if (has_second) {
    bench.wire.send(Sender::noise, 0xFF, bit_3 + bit * 10 / 16 - spike.bit / 2, spike);
  }
  bench.run(2ms);
  CHECK(bench.module.values() == (has_second ? Bytes{0xF7} : Bytes{0xFF}));
}

TEST_CASE("A cut cable parts the two, each still hears itself", "[SB-1.4]") {
  Bench bench;
  bench.wire.cut(1ms);
  CHECK(bench.wire.is_cut());
  bench.wire.send(Sender::sr, 0x60, 2ms);
  bench.wire.send(Sender::spm, 0x61, 3ms);
  bench.run(4ms);
  CHECK(bench.remote.values() == Bytes{0x60});
  CHECK(bench.module.values() == Bytes{0x61});
  REQUIRE(bench.log.size() == 2);
  CHECK(bench.log[0].lost);
  CHECK_FALSE(bench.log[1].lost);

  bench.wire.mend(5ms);
  CHECK_FALSE(bench.wire.is_cut());
  bench.wire.send(Sender::sr, 0x0F, 6ms);
  bench.run(7ms);
  CHECK(bench.remote.values() == Bytes{0x60, 0x0F});
  CHECK(bench.module.values() == Bytes{0x61, 0x0F});
  CHECK_FALSE(bench.log[2].lost);
}

TEST_CASE("With the cable cut both may speak at once") {
  Bench bench;
  bench.wire.cut(0ms);
  bench.wire.send(Sender::spm, 0x61, 1ms);
  bench.wire.send(Sender::sr, 0x5C, 1ms + 5us);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0x61});
  CHECK(bench.remote.values() == Bytes{0x5C});
}

TEST_CASE("A cable mended within a character lets its rest be heard") {
  Bench bench;
  bench.wire.cut(0ms);
  bench.wire.send(Sender::sr, 0x00, 1ms);
  bench.run(1ms + 3 * bit);
  bench.wire.mend(1ms + 3 * bit);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0xE0});  // six bits were left, the first of them taken for the start bit
}

TEST_CASE("A cable cut within a character leaves recessive bits") {
  Bench bench;
  bench.wire.send(Sender::sr, 0x00, 1ms);
  bench.run(1ms + 3 * bit);
  bench.wire.cut(1ms + 3 * bit);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0xFC});
  CHECK(bench.remote.values() == Bytes{0x00});
}

TEST_CASE("Nothing is heard while wake is asserted", "[SB-1.3]") {
  Bench bench;
  bench.wire.hold_wake(true, 1ms);
  bench.wire.send(Sender::sr, general, 2ms);
  bench.run(10ms);
  CHECK(bench.remote.heard.empty());
  CHECK(bench.module.heard.empty());
  CHECK(bench.log.size() == general.size());
  CHECK(bench.log[0].lost);
  bench.wire.hold_wake(false, 10ms);
  bench.wire.send(Sender::sr, 0x0F, 10ms);
  bench.run(11ms);
  CHECK(bench.module.values() == Bytes{0x0F});
  CHECK(bench.wakes == std::vector<std::pair<bool, Time>>{{true, 1ms}, {false, 10ms}});
}

TEST_CASE("A character in progress is lost when wake rises", "[SB-1.3]") {
  Bench bench;
  bench.wire.send(Sender::sr, 0x60, 1ms);
  bench.run(1ms + 5 * bit);
  bench.wire.hold_wake(true, 1ms + 5 * bit);
  bench.run(20ms);
  CHECK(bench.module.heard.empty());
}

TEST_CASE("The rest of a character is heard when wake falls, as on a real wire", "[SB-1.3]") {
  Bench bench;
  bench.wire.hold_wake(true, 0ms);
  bench.wire.send(Sender::sr, 0x00, 1ms);
  bench.run(1ms + 3 * bit);
  bench.wire.hold_wake(false, 1ms + 3 * bit);
  bench.run(2ms);
  CHECK(bench.module.values() == Bytes{0xE0});
}

TEST_CASE("A wake pulse ends by itself, but not while the remote holds wake") {
  Bench bench;
  bench.wire.pulse_wake(1ms, 5ms);
  CHECK(bench.wire.is_wake_asserted());
  CHECK(bench.wire.next_time() == 6ms);
  bench.run(8ms);
  CHECK(bench.wakes == std::vector<std::pair<bool, Time>>{{true, 1ms}, {false, 6ms}});
  bench.wire.pulse_wake(10ms, 5ms);
  bench.wire.hold_wake(true, 12ms);
  bench.run(20ms);
  CHECK(bench.wire.is_wake_asserted());
  bench.wire.hold_wake(false, 20ms);
  CHECK_FALSE(bench.wire.is_wake_asserted());
}

TEST_CASE("The checksums of the next packets of one kind are wrong", "[SB-2.5]") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::corrupt_checksum, Sender::sr, 0x0, 0, 0, 2});
  bench.wire.send(Sender::sr, general, 0ms);
  bench.wire.send(Sender::sr, power_up, 20ms);
  bench.wire.send(Sender::sr, general, 40ms);
  bench.wire.send(Sender::sr, general, 60ms);
  bench.run(80ms);
  const Bytes corrupt{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDD, 0x0F};
  Bytes expected = corrupt;
  expected.insert(expected.end(), power_up.begin(), power_up.end());
  expected.insert(expected.end(), corrupt.begin(), corrupt.end());
  expected.insert(expected.end(), general.begin(), general.end());
  CHECK(bench.module.values() == expected);
  CHECK(bench.remote.values() == expected);
  CHECK(bench.log[8].sent == 0xDC);
  CHECK(bench.log[8].heard == 0xDD);
}

TEST_CASE("One bit of one byte flips") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::flip_bit, Sender::sr, 0x0, 6, 3, 1});
  bench.wire.send(Sender::sr, general, 0ms);
  bench.wire.send(Sender::sr, general, 20ms);
  bench.run(40ms);
  const Bytes heard = bench.module.values();
  CHECK(Bytes(heard.begin(), heard.begin() + 10) == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x8C, 0x80, 0xDC, 0x0F});
  CHECK(Bytes(heard.begin() + 10, heard.end()) == general);
}

TEST_CASE("A byte is lost, its place on the line stays empty") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::drop, Sender::sr, 0x0, 4, 0, 1});
  bench.wire.send(Sender::sr, general, 0ms);
  bench.run(20ms);
  CHECK(bench.module.values() == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0x80, 0x84, 0x80, 0xDC, 0x0F});
  CHECK(bench.module.heard[4].at - bench.module.heard[3].at == 2 * character);
  REQUIRE(bench.log.size() == 10);
  CHECK(bench.log[4].lost);
}

TEST_CASE("A byte whose stop bit is dominant is a framing error, and nothing but that", "[SB-2.10]") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::framing_error, Sender::sr, 0x0, 4, 0, 1});
  bench.wire.send(Sender::sr, general, 0ms);
  bench.wire.send(Sender::sr, general, 20ms);
  bench.run(40ms);
  Bytes twice = general;
  twice.insert(twice.end(), general.begin(), general.end());
  CHECK(bench.module.values() == twice);
  for (std::size_t i = 0; i < twice.size(); ++i) {
    CHECK(bench.module.heard[i].framing_error == (i == 4));
    CHECK(bench.log[i].spoiled == (i == 4));
  }
}

TEST_CASE("A late byte takes the rest of its turn along, and no other turn", "[SB-2.11]") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::late_byte, Sender::sr, 0x0, 3, 0, 1, 2600us});
  bench.wire.send(Sender::sr, general, 0ms);
  bench.wire.send(Sender::sacu, 0x0F, 8ms);
  bench.wire.send(Sender::sr, general, 20ms);
  bench.run(40ms);
  REQUIRE(bench.log.size() == 21);
  CHECK(bench.log[2].start == 2 * character);
  CHECK(bench.log[3].start == 3 * character + 2600us);
  CHECK(bench.log[9].start == 9 * character + 2600us);
  CHECK(bench.log[10].start == 8ms);
  CHECK(bench.log[11].start == 20ms);
  CHECK(bench.log[20].start == 20ms + 9 * character);
  CHECK(bench.module.heard.size() == 21);
}

TEST_CASE("TF is a packet of its own, whoever else says it") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::drop, Sender::sr, 0xF, 0, 0, 1});
  bench.wire.send(Sender::spm, 0x0F, 0ms);
  bench.wire.send(Sender::sr, general, 1ms);
  bench.wire.send(Sender::sr, 0x0F, 20ms);
  bench.run(30ms);
  CHECK(bench.module.values() == Bytes{0x0F, 0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F});
}

TEST_CASE("TF has no checksum that could be wrong") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::corrupt_checksum, Sender::sr, 0xF, 0, 0, 1});
  bench.wire.send(Sender::sr, 0x0F, 0ms);
  bench.run(1ms);
  CHECK(bench.module.values() == Bytes{0x0F});
}

TEST_CASE("What follows a disturbed packet is left alone") {
  Bench bench;
  bench.wire.disturb({Disturbance::Way::flip_bit, Sender::spm, 0x5, 4, 0, 1});
  bench.wire.send(Sender::spm, {0x05, 0x80, 0xFA, 0x80, 0x80, 0x80}, 0ms);
  bench.run(5ms);
  CHECK(bench.module.values() == Bytes{0x05, 0x80, 0xFA, 0x80, 0x80, 0x80});
}

TEST_CASE("Babble is back to back, ends, and is the same for the same seed") {
  const auto babble = [](std::uint64_t seed) {
    Bench bench(seed);
    bench.wire.babble(1ms, 10ms);
    bench.run(50ms);
    return bench;
  };
  const Bench once = babble(7);
  CHECK(once.log.size() == 35);  // characters of 286 us that begin within 10 ms
  CHECK(once.log[1].start - once.log[0].start == character);
  CHECK(once.log.back().start < 11ms);
  CHECK(once.module.values() == once.logged());
  CHECK(once.wire.next_time() == Time::max());
  CHECK(babble(7).logged() == once.logged());
  CHECK(babble(8).logged() != once.logged());
}

TEST_CASE("Babble of half the time leaves a character's pause behind each") {
  Bench bench;
  bench.wire.babble(1ms, 10ms, 0.5);
  bench.run(50ms);
  CHECK(bench.log.size() == 18);  // one in 573 us
  CHECK(bench.log[1].start - bench.log[0].start == 2 * character);
}

TEST_CASE("A transmitter that hangs sends zeros without a stop bit, until it ends", "[H-34]") {
  Bench bench;
  bench.wire.jam(1ms, 10ms);
  bench.run(50ms);
  CHECK(bench.log.size() == 35);
  for (const BusByte& byte : bench.log) {
    CHECK(byte.heard == 0);
    CHECK(byte.spoiled);
  }
  CHECK(bench.wire.next_time() == Time::max());
}

TEST_CASE("Babble over a turn leaves neither as it was", "[SB-2.18]") {
  Bench bench;
  bench.wire.babble(0ms, 10ms);
  bench.wire.send(Sender::sr, general, 3100us);
  bench.run(20ms);
  int garbled = 0;
  for (const BusByte& byte : bench.log) {
    garbled += byte.heard != byte.sent ? 1 : 0;
  }
  CHECK(garbled >= 10);
}
