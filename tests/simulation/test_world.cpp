#include "simulation/world.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

// A power module that does what the test says.
class PuppetBoard final : public SpmBoard {
 public:
  std::string name() const override { return "puppet"; }
  void power(bool on, Time now) override {
    is_on = on;
    powered_at = now;
  }
  bool is_powered() const override { return is_on; }
  void reset(ResetKind, Time) override {}
  void upset(const Upset&) override {}
  Time run_until(Time limit) override {
    if (!to_say.empty() && is_on && say_at <= limit) {
      now = say_at;
      speak(to_say.front(), say_at);
      to_say.erase(to_say.begin());
      say_at += 286us;
      return now;
    }
    return now = limit;
  }
  void hear(const Reception& reception) override {
    CHECK(now == reception.at);
    heard.push_back(reception.value);
  }
  void surround(const Surroundings& now_around) override { around = now_around; }
  Pins pins() const override { return is_on ? levels : Pins{}; }
  Time bit_time() const override { return 26us; }
  void on_speak(Speak the_speak) override { speak = std::move(the_speak); }
  std::vector<std::uint8_t> eeprom() const override { return {}; }
  void set_eeprom(const std::vector<std::uint8_t>&) override {}
  BoardStatistics statistics() const override { return {}; }

  bool is_on = false;
  Time powered_at{};
  Time now{};
  Bytes heard;
  Surroundings around;
  Pins levels;
  Speak speak;
  Bytes to_say;
  Time say_at{};
};

struct Diary final : Observer {
  std::vector<Time> samples;
  std::vector<std::pair<bool, Time>> wakes;
  std::vector<std::pair<bool, Time>> powers;
  std::vector<BusByte> bytes;
  Time latest{};

  void note(Time at) {
    CHECK(at >= latest);
    latest = at;
  }
  void on_byte(const BusByte& byte) override {
    note(byte.start + 250'654ns);  // when its first stop bit has been sampled
    bytes.push_back(byte);
  }
  void on_wake(bool asserted, Time at) override {
    note(at);
    wakes.emplace_back(asserted, at);
  }
  void on_power(bool powered, Time at) override {
    note(at);
    powers.emplace_back(powered, at);
  }
  void on_sample(const Sample& sample) override {
    note(sample.at);
    samples.push_back(sample.at);
  }
};

struct Bench {
  explicit Bench(std::uint64_t seed = 1)
      : owned(std::make_unique<PuppetBoard>()), board(*owned), world(std::move(owned), seed) {
    world.observe(diary);
  }
  std::unique_ptr<PuppetBoard> owned;
  PuppetBoard& board;
  World world;
  Diary diary;
};

using Edges = std::vector<std::pair<bool, Time>>;

}  // namespace

TEST_CASE("The press wakes the power module in the same moment", "[SB-1.2]") {
  Bench bench;
  bench.world.run_for(10ms + 300us);
  CHECK_FALSE(bench.board.is_on);
  bench.world.remote().start(bench.world.now());
  CHECK(bench.board.is_on);
  CHECK(bench.board.powered_at == 10ms + 300us);
  CHECK(bench.board.around.wake);
  CHECK(bench.world.spm_powered());
  bench.world.run_for(300ms);
  CHECK_FALSE(bench.board.around.wake);
  CHECK(bench.diary.wakes == Edges{{true, 10ms + 300us}, {false, 310ms + 300us}});
}

TEST_CASE("Without its latch the power module dies 250 ms after wake") {
  Bench bench;
  bench.world.remote().start(bench.world.now());
  bench.world.run_for(1s);
  REQUIRE(bench.diary.powers.size() == 2);
  CHECK(bench.diary.powers[0] == std::pair<bool, Time>{true, 0ms});
  CHECK(bench.diary.powers[1] == std::pair<bool, Time>{false, 550ms});
}

TEST_CASE("The latch holds the supply, and 250 ms longer", "[SB-1.2]") {
  Bench bench;
  bench.world.remote().start(bench.world.now());
  bench.board.levels.power_latch = true;
  bench.world.run_for(2s);
  CHECK(bench.world.spm_powered());
  bench.board.levels.power_latch = false;
  bench.world.run_for(249ms);
  CHECK(bench.world.spm_powered());
  bench.world.run_for(2ms);
  CHECK_FALSE(bench.world.spm_powered());
  CHECK_FALSE(bench.world.latest().spm_powered);
}

TEST_CASE("The hold bridges a reset during which the latch is low", "[SB-3.9]") {
  Bench bench;
  bench.world.remote().start(bench.world.now());
  bench.board.levels.power_latch = true;
  bench.world.run_for(1s);
  for (int i = 0; i < 3; ++i) {
    bench.board.levels.power_latch = false;
    bench.world.run_for(200ms);
    bench.board.levels.power_latch = true;
    bench.world.run_for(10ms);
  }
  CHECK(bench.diary.powers.size() == 1);
}

TEST_CASE("A wake pulse from elsewhere wakes as the remote does") {
  Bench bench;
  bench.world.run_for(5ms);
  bench.world.wire().pulse_wake(bench.world.now(), 20ms);
  CHECK(bench.world.spm_powered());
  bench.world.run_for(300ms);
  CHECK(bench.diary.wakes == Edges{{true, 5ms}, {false, 25ms}});
  CHECK(bench.diary.powers == Edges{{true, 5ms}, {false, 275ms}});
}

TEST_CASE("The power module hears the remote, and itself", "[SB-1.4]") {
  Bench bench;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.board.to_say = {0x05, 0x80, 0xFA, 0x0F};
  bench.board.say_at = 23'200us;  // after the remote's power-up packet, from 20 ms on
  bench.world.run_for(30ms);
  CHECK(bench.board.heard == Bytes{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1, 0x0F,  //
                                   0x05, 0x80, 0xFA, 0x0F});
  CHECK(bench.world.remote().is_sending_generals());
  REQUIRE(bench.diary.bytes.size() == 15);
  CHECK(bench.diary.bytes[0].sender == Sender::sr);
  CHECK(bench.diary.bytes[0].start == 20ms);
  CHECK(bench.diary.bytes[11].sender == Sender::spm);
  CHECK(bench.diary.bytes[11].start == 23'200us);
  CHECK(bench.diary.bytes[12].start == 23'486us);
}

TEST_CASE("A cut cable keeps the remote's turn from the power module") {
  Bench bench;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.world.wire().cut(bench.world.now());
  bench.world.run_for(30ms);
  CHECK(bench.board.heard.empty());
  bench.world.wire().mend(bench.world.now());
  bench.world.run_for(20ms);
  CHECK(bench.board.heard.size() == 11);
}

TEST_CASE("An attendant control is there only when it is plugged in, and everybody hears it", "[SB-2.8]") {
  Bench bench;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.board.levels.power_latch = true;
  bench.board.to_say = {0x05, 0x80, 0xFA, 0x0F};
  bench.board.say_at = 23'200us;
  bench.world.run_for(30ms);
  CHECK_FALSE(bench.world.sacu().is_attached());
  CHECK(bench.board.heard.size() == 15);

  bench.world.attach_sacu();
  bench.world.attach_sacu();  // once is enough
  bench.board.heard.clear();
  bench.board.to_say = {0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F};
  bench.board.say_at = 42'950us;
  bench.world.run_for(20ms);
  CHECK(bench.board.heard == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F,  //
                                   0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F,  //
                                   0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C, 0x0F});
  CHECK(bench.diary.bytes.back().sender == Sender::sacu);
  CHECK(bench.world.remote().statistics().answers == 1);
  CHECK(bench.world.remote().statistics().bad == 0);
  CHECK(bench.world.sacu().bad() == 0);

  bench.world.detach_sacu();
  bench.board.to_say = {0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F};
  bench.board.say_at = 62'950us;
  bench.world.run_for(20ms);
  CHECK(bench.board.heard.size() == 50);
}

TEST_CASE("The attendant control sits at the power module's end of a cut cable") {
  Bench bench;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.world.attach_sacu();
  bench.world.wire().cut(bench.world.now());
  bench.board.to_say = {0x05, 0x80, 0xFA, 0x0F};
  bench.board.say_at = 23'200us;
  bench.world.run_for(30ms);
  CHECK(bench.board.heard == Bytes{0x05, 0x80, 0xFA, 0x0F, 0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C, 0x0F});
  CHECK_FALSE(bench.world.remote().is_sending_generals());
}

TEST_CASE("Who is plugged in while somebody speaks hears the rest as strays") {
  Bench bench;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.world.run_until(21ms);
  bench.world.attach_sacu();
  bench.world.run_for(9ms);
  CHECK(bench.world.sacu().bad() == 1);
}

TEST_CASE("Samples come every millisecond and tell pins, controls and chair") {
  Bench bench;
  bench.board.is_on = true;
  bench.world.remote().controls.speed = 700;
  bench.board.levels.motor_relay = true;
  bench.world.remote().start(bench.world.now());
  bench.world.run_for(10ms);
  REQUIRE(bench.diary.samples.size() == 10);
  CHECK(bench.diary.samples.front() == 1ms);
  CHECK(bench.diary.samples.back() == 10ms);
  CHECK(bench.world.latest().at == 10ms);
  CHECK(bench.world.latest().pins.motor_relay);
  CHECK(bench.world.latest().controls.speed == 700);
  CHECK(bench.world.latest().chair.battery_volts > 20);
}

TEST_CASE("The chair's voltages reach the power module, its pins the chair") {
  Bench bench;
  bench.board.levels.power_latch = bench.board.levels.bridge_enable = bench.board.levels.motor_relay = true;
  bench.board.levels.left_brake_release = bench.board.levels.right_brake_release = true;
  bench.board.levels.left_forward = bench.board.levels.right_forward = true;
  bench.board.levels.left_duty = bench.board.levels.right_duty = 200;
  bench.world.remote().start(bench.world.now());
  bench.world.run_for(1s);
  CHECK(bench.world.chair().state().speed > 0.3);
  CHECK(bench.board.around.analog_volts[0] == Approx(25.0 / 8).margin(0.1));
  CHECK(bench.board.around.analog_volts[3] == Approx(1.3));  // both brake coils
}

TEST_CASE("The seat's input and the lighting strap reach the power module", "[negotiation]") {
  Bench bench;
  CHECK(bench.board.around.lighting_fitted);
  CHECK_FALSE(bench.board.around.dci_slowdown);
  bench.world.fit_lighting(false);
  bench.world.ask_for_slow(true);
  CHECK_FALSE(bench.board.around.lighting_fitted);
  CHECK(bench.board.around.dci_slowdown);
  bench.world.run_for(5ms);
  CHECK_FALSE(bench.board.around.lighting_fitted);
  CHECK(bench.board.around.dci_slowdown);
  bench.world.ask_for_slow(false);
  CHECK_FALSE(bench.board.around.dci_slowdown);
}

TEST_CASE("A power module that is not there is not woken", "[SB-07.1][negotiation]") {
  Bench bench;
  bench.world.fit_power_module(false);
  bench.world.remote().start(bench.world.now());
  bench.world.run_for(1s);
  CHECK_FALSE(bench.board.is_on);
  CHECK(bench.diary.powers.empty());
  CHECK(bench.world.remote().is_on());
}

TEST_CASE("A tester is heard by the remote, whose answer is on the line", "[SB-07.1][negotiation]") {
  Bench bench;
  bench.world.fit_power_module(false);
  bench.world.remote().is_silent = true;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.world.attach_sacu();
  bench.world.run_for(10ms);
  bench.world.wire().send(Sender::tester, {0x27, 0x95, 0x81, 0x82, 0xC0, 0x0F}, bench.world.now());
  bench.world.run_for(10ms);
  bench.world.wire().send(Sender::tester, {0x27, 0x85, 0x81, 0x82, 0xD0, 0x0F}, bench.world.now());
  bench.world.run_for(10ms);
  REQUIRE(bench.diary.bytes.size() == 24);
  CHECK(bench.diary.bytes[0].sender == Sender::tester);
  CHECK(bench.diary.bytes[6].sender == Sender::sacu);
  CHECK(bench.diary.bytes[18].sender == Sender::sr);
  CHECK(int(bench.diary.bytes[18].heard) == 0x27);
  CHECK(int(bench.diary.bytes[19].heard) == 0x85);
  CHECK(int(bench.diary.bytes[23].heard) == 0x0F);
}

TEST_CASE("A module does not answer what somebody says in its name", "[SB-07.1][negotiation]") {
  Bench bench;
  bench.world.fit_power_module(false);
  bench.world.remote().is_silent = true;
  bench.world.remote().timing.wake = 5ms;
  bench.world.remote().start(bench.world.now());
  bench.world.attach_sacu();
  bench.world.run_for(10ms);
  const auto answer_to = [&](Sender sender, const Bytes& bytes) {
    bench.diary.bytes.clear();
    bench.world.say_as(sender, bytes);
    bench.world.run_for(10ms);
    return bench.diary.bytes.size() - bytes.size();
  };
  const Bytes to_remote{0x27, 0x85, 0x81, 0x82, 0xD0};
  const Bytes to_sacu{0x27, 0x95, 0x81, 0x82, 0xC0};
  CHECK(answer_to(Sender::sr, to_remote) == 0);
  CHECK(answer_to(Sender::sr, to_sacu) == 6);
  CHECK(answer_to(Sender::sacu, to_sacu) == 0);
  CHECK(answer_to(Sender::sacu, to_remote) == 6);
  CHECK(answer_to(Sender::tester, to_remote) == 6);
  CHECK(answer_to(Sender::tester, to_sacu) == 6);
}

TEST_CASE("Two worlds with one seed tell the same story") {
  const auto story = [](std::uint64_t seed) {
    Bench bench(seed);
    bench.world.remote().start(bench.world.now());
    bench.world.run_for(310ms);
    bench.world.wire().babble(bench.world.now(), 20ms);
    bench.world.run_for(100ms);
    return bench.board.heard;
  };
  CHECK(story(3).size() > 60);
  CHECK(story(3) == story(3));
  CHECK(story(3) != story(4));
}

TEST_CASE("Time stops where it was told to") {
  Bench bench;
  bench.world.run_until(1234us);
  CHECK(bench.world.now() == 1234us);
  bench.world.run_for(1us);
  CHECK(bench.world.now() == 1235us);
  CHECK(bench.diary.samples == std::vector<Time>{1ms});
}
