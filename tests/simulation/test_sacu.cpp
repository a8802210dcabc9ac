#include "simulation/models/sacu.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

constexpr Time character{286'458};
constexpr Time sampled_after{250'651};  // 9.625 bits

// Turns of the others, worked out by hand (SB-2.5).
const Bytes sr_turn{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F};
const Bytes spm_general{0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F};
const Bytes spm_acknowledges{0x61, 0x80, 0x80, 0x80, 0x80, 0x90, 0x80, 0x80, 0x8E, 0x0F};
const Bytes spm_power_up{0x05, 0x87, 0xF3, 0x0F};

// What a real one was heard to say.
const Bytes power_up{0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C};
const Bytes power_up_turn{0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C, 0x0F};
const Bytes general{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4};
const Bytes general_turn{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4, 0x0F};

struct Line {
  Sacu sacu;
  Bytes turn;
  std::vector<Time> starts;
  Time now{};

  Line() {
    sacu.on_transmit([this](std::uint8_t value, Time start) {
      turn.push_back(value);
      starts.push_back(start);
    });
    sacu.controls.is_attendant = true;
    sacu.attach();
  }
  // Others speak; afterwards `now` is the end of their last stop bit.
  void say(const Bytes& bytes) {
    for (const std::uint8_t byte : bytes) {
      sacu.hear({byte, false, now + sampled_after});
      now += character;
    }
  }
  // A cycle: remote, power module, and what the SACU says within 10 ms.
  Bytes cycle(const Bytes& answer) {
    say(sr_turn);
    say(answer);
    return listen();
  }
  Bytes listen() {
    turn.clear();
    starts.clear();
    const Time limit = now + 10ms;
    for (Time due = sacu.next_time(); due <= limit; due = sacu.next_time()) {
      sacu.act(due);
    }
    now = limit;
    return turn;
  }
};

}  // namespace

TEST_CASE("The attendant control's packets are those of a real one", "[SB-09.1][SB-08.1]") {
  Sacu sacu;
  CHECK(sacu.power_up_packet() == power_up);
  sacu.controls.is_attendant = true;
  CHECK(sacu.general_packet() == general);
}

TEST_CASE("The attendant's readings are spread as the remote's", "[SB-08.1]") {
  Sacu sacu;
  sacu.controls.speed = 1022;
  sacu.controls.direction = 514;
  sacu.controls.pot = 0;
  CHECK(sacu.general_packet() == Bytes{0x58, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x80, 0xB6});
}

TEST_CASE("Every switch of the attendant control has its own bit", "[SB-08.1]") {
  Sacu sacu;
  const auto byte4 = [&](bool SacuControls::*member) {
    sacu.controls.*member = true;
    const int value = sacu.general_packet()[5] & 0x7F;
    sacu.controls.*member = false;
    return value;
  };
  CHECK(byte4(&SacuControls::joystick_error) == 0x40);
  CHECK(byte4(&SacuControls::pot_error) == 0x20);
  CHECK(byte4(&SacuControls::local_fault) == 0x10);
  CHECK(byte4(&SacuControls::calibration_active) == 0x08);
  CHECK(byte4(&SacuControls::is_attendant) == 0x04);
  CHECK(byte4(&SacuControls::non_critical_fault) == 0x02);
  CHECK(byte4(&SacuControls::drive_inhibit) == 0x01);
  sacu.controls.mode = 3;
  CHECK(sacu.general_packet()[6] == 0x83);
}

TEST_CASE("The attendant control speaks 100 us after the power module's TF, back to back", "[SB-2.8][SB-2.1]") {
  Line line;
  line.say(sr_turn);
  CHECK(line.listen().empty());
  line.say(spm_general);
  const Time ended = line.now;
  CHECK(line.listen() == power_up_turn);
  CHECK(line.starts[0] - ended >= 99us);
  CHECK(line.starts[0] - ended <= 101us);
  CHECK(line.starts[9] - line.starts[0] == Time(2'578'125));  // 99 bits
}

TEST_CASE("The power-up packet goes out every cycle until a general acknowledges it", "[SB-09.1]") {
  Line line;
  for (int cycle = 0; cycle < 100; ++cycle) {
    REQUIRE(line.cycle(spm_general) == power_up_turn);
  }
  CHECK_FALSE(line.sacu.is_acknowledged());
  CHECK(line.cycle(spm_acknowledges) == general_turn);
  CHECK(line.sacu.is_acknowledged());
  CHECK(line.cycle(spm_general) == general_turn);
}

TEST_CASE("It introduces itself in the power-up phase, too, and anew when that begins again", "[SB-09.1]") {
  Line line;
  CHECK(line.cycle(spm_power_up) == power_up_turn);
  CHECK(line.cycle(spm_acknowledges) == general_turn);
  CHECK(line.cycle(spm_power_up) == power_up_turn);
  CHECK(line.cycle(spm_general) == power_up_turn);
}

TEST_CASE("An acknowledgement from before its own power-up packet does not count", "[SB-09.1]") {
  Line line;
  CHECK(line.cycle(spm_acknowledges) == power_up_turn);
  CHECK(line.cycle(spm_acknowledges) == general_turn);
  line.sacu.detach();
  line.sacu.attach();
  CHECK(line.cycle(spm_acknowledges) == power_up_turn);
}

TEST_CASE("One that insists does not wait for its acknowledgement") {
  Line line;
  line.sacu.insists = true;
  CHECK(line.cycle(spm_general) == general_turn);
}

TEST_CASE("Without a power module it says nothing", "[SB-2.8]") {
  Line line;
  SECTION("only the remote speaks") {
    CHECK(line.cycle({}).empty());
  }
  SECTION("the answer is corrupt") {
    CHECK(line.cycle({0x05, 0x87, 0xF2, 0x0F}).empty());
  }
  SECTION("not attached") {
    line.sacu.detach();
    CHECK(line.cycle(spm_general).empty());
    CHECK(line.sacu.next_time() == Time::max());
  }
  SECTION("silent") {
    line.sacu.is_silent = true;
    CHECK(line.cycle(spm_general).empty());
  }
}

TEST_CASE("When the power module's TF is lost it speaks after 3 ms of silence", "[SB-2.12]") {
  Line line;
  line.say(sr_turn);
  line.say({0x05, 0x87, 0xF3});
  const Time ended = line.now;
  CHECK(line.listen() == power_up_turn);
  CHECK(line.starts[0] - ended >= Time(2'999us));
  CHECK(line.starts[0] - ended <= Time(3'001us));
}

TEST_CASE("A rash one follows the remote's TF", "[SB-2.18]") {
  Line line;
  line.sacu.timing.is_rash = true;
  line.sacu.timing.pause = 400us;
  line.say(sr_turn);
  const Time ended = line.now;
  CHECK(line.listen() == power_up_turn);
  CHECK(line.starts[0] - ended >= 399us);
  CHECK(line.starts[0] - ended <= 401us);
  line.say(spm_general);
  CHECK(line.listen().empty());
}

TEST_CASE("Its own echo passes unread") {
  Line line;
  line.sacu.insists = true;
  line.cycle(spm_general);
  line.now = line.starts[0];
  line.say(line.turn);
  CHECK(line.sacu.bad() == 0);
  CHECK(line.listen().empty());
}

TEST_CASE("The longest turn of an attendant control has 12 bytes", "[SB-2.2][SB-06.1]") {
  Line line;
  line.sacu.insists = line.sacu.sends_calibration = true;
  CHECK(line.cycle(spm_general) == Bytes{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4, 0x06, 0x80, 0xF9, 0x0F});
}

TEST_CASE("Its calibration tells where the stick has been", "[SB-06.1]") {
  Line line;
  line.sacu.insists = line.sacu.controls.calibration_active = true;
  line.sacu.controls.speed = 1000;
  CHECK(line.cycle(spm_general)[9] == 0x88);
  line.sacu.controls.speed = 20;
  CHECK(line.cycle(spm_general)[9] == 0x8C);
  line.sacu.controls.speed = 512;
  line.sacu.controls.direction = 20;
  CHECK(line.cycle(spm_general)[9] == 0x8E);
  line.sacu.controls.direction = 1000;
  CHECK(line.cycle(spm_general)[9] == 0x8F);
  line.sacu.controls.direction = 512;
  CHECK(line.cycle(spm_general)[9] == 0x9F);
  line.sacu.controls.calibration_second_pass = true;
  CHECK(line.cycle(spm_general)[9] == 0xBF);
  line.sacu.controls.calibration_active = false;
  CHECK(line.cycle(spm_general).size() == 9);
  line.sacu.controls.calibration_active = true;
  CHECK(line.cycle(spm_general)[9] == 0xA0);
}

TEST_CASE("It takes in what the power module reports about it", "[SB-01.4][SB-01.5][SB-01.7]") {
  Line line;
  line.cycle({0x61, 0x80, 0x80, 0x80, 0xC0, 0xF0, 0x80, 0xA0, 0xCE, 0x0F});
  const SpmReport& report = line.sacu.report();
  CHECK(report.is_sacu_driving());
  CHECK(report.is_sacu_calibrating());
  CHECK(report.is_sacu_drive_modified());
  CHECK(report.is_sacu_acknowledged());
  CHECK(report.is_sacu_mode_invalid());
  CHECK(report.speedo() == 0);
}

TEST_CASE("It has a clock and gaps of its own") {
  Line line;
  line.sacu.insists = true;
  line.sacu.timing.bit_us = 25;
  line.sacu.timing.stop_bits = 1;
  line.sacu.timing.gap = 200us;
  line.cycle(spm_general);
  CHECK(line.starts[1] - line.starts[0] == 450us);
  CHECK(line.sacu.turn_ended_at() == line.starts[8] + 250us);
}
