#include "simulation/models/remote.hpp"

#include <catch2/catch.hpp>

#include <utility>

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

constexpr Time bit{26042};

// SPM general, 7 data bytes 0, and one with "power down now"; each with TF. Worked out by hand (SB-2.5).
const Bytes quiet_general{0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F};
const Bytes power_down_general{0x61, 0x80, 0x90, 0x80, 0x80, 0x80, 0x80, 0x80, 0x8E, 0x0F};
const Bytes power_up{0x05, 0x87, 0xF3, 0x0F};

struct Line {
  Remote remote;
  Bytes turn;
  std::vector<Time> starts;
  std::vector<std::pair<bool, Time>> wakes;

  Line() {
    remote.on_transmit([this](std::uint8_t value, Time start) {
      turn.push_back(value);
      starts.push_back(start);
    });
    remote.on_wake([this](bool asserted, Time at) { wakes.emplace_back(asserted, at); });
  }
  Time act() {
    turn.clear();
    starts.clear();
    const Time now = remote.next_time();
    remote.act(now);
    return now;
  }
  void say(const Bytes& bytes, Time from) {
    for (const std::uint8_t byte : bytes) {
      remote.hear({byte, false, from + Time(250651)});  // 9.625 bits
      from += 11 * bit;
    }
  }
  void answer(const Bytes& bytes) { say(bytes, remote.turn_ended_at() + 60us); }
  void bring_up() {
    remote.start(0ms);
    act();
    answer(power_up);
  }
};

}  // namespace

TEST_CASE("The remote's power-up packet is the document's", "[SB-04.1][SB-2.3][SB-2.4][SB-2.5]") {
  Remote remote;
  CHECK(remote.power_up_packet() == Bytes{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1});
  remote.identity.power_up_length = 6;
  CHECK(remote.power_up_packet() == Bytes{0x54, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA9});
}

TEST_CASE("The remote's general spreads its readings as the document says", "[SB-00.1][SB-00.2][SB-00.3]") {
  Remote remote;
  remote.controls.speed = 1022;
  remote.controls.direction = 514;
  remote.controls.pot = 0;
  CHECK(remote.general_packet() == Bytes{0x60, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x80, 0xAA});
  remote.identity.general_length = 6;
  CHECK(remote.general_packet() == Bytes{0x50, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0xBA});
}

TEST_CASE("Every switch of the remote has its own bit", "[SB-00.2]") {
  Remote remote;
  remote.is_insistent = true;
  RemoteControls& c = remote.controls;
  c.hhp_may_send = false;
  const auto byte = [&](bool RemoteControls::*member, std::size_t index) {
    c.*member = true;
    const int value = remote.general_packet()[index + 1] & 0x7F;
    c.*member = false;
    return value;
  };
  CHECK(byte(&RemoteControls::joystick_error, 4) == 0x40);
  CHECK(byte(&RemoteControls::pot_error, 4) == 0x20);
  CHECK(byte(&RemoteControls::local_fault, 4) == 0x10);
  CHECK(byte(&RemoteControls::charger_inhibit, 4) == 0x08);
  CHECK(byte(&RemoteControls::power_button, 4) == 0x04);
  CHECK(byte(&RemoteControls::horn, 4) == 0x02);
  CHECK(byte(&RemoteControls::lock, 4) == 0x01);
  CHECK(byte(&RemoteControls::hazard, 5) == 0x40);
  CHECK(byte(&RemoteControls::left_indicator, 5) == 0x20);
  CHECK(byte(&RemoteControls::right_indicator, 5) == 0x10);
  CHECK(byte(&RemoteControls::remote_inhibit, 5) == 0x08);
  CHECK(byte(&RemoteControls::hhp_may_send, 5) == 0x04);
  CHECK(byte(&RemoteControls::calibration_active, 5) == 0x02);
  CHECK(byte(&RemoteControls::non_critical_fault, 6) == 0x20);
  CHECK(byte(&RemoteControls::headlight, 6) == 0x10);
}

TEST_CASE("The press wakes for 300 ms and a turn is sent back to back", "[SB-2.1][SB-3.5]") {
  Line line;
  CHECK(line.remote.next_time() == Time::max());
  line.remote.start(5ms);
  CHECK(line.remote.wake_asserted(304ms));
  CHECK_FALSE(line.remote.wake_asserted(305ms));
  CHECK(line.act() == 25ms);
  REQUIRE(line.turn == Bytes{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1, 0x0F});
  CHECK(line.starts[0] == 25ms);
  CHECK(line.starts[1] == 25ms + Time(286458));
  CHECK(line.starts[10] == 25ms + Time(2864583));
  CHECK(line.remote.turn_ended_at() == 25ms + Time(3151042));
  while (line.remote.next_time() <= 305ms) {
    line.act();
  }
  CHECK(line.wakes == std::vector<std::pair<bool, Time>>{{true, 5ms}, {false, 305ms}});
}

TEST_CASE("The power-up packet repeats until answered and generals follow", "[SB-3.5]") {
  Line line;
  line.remote.start(0ms);
  CHECK(line.act() == 20ms);
  line.say(line.turn, 20ms);              // its own echo
  line.answer({0x05, 0x87, 0xF2, 0x0F});  // a wrong checksum
  CHECK(line.remote.statistics().bad == 1);
  CHECK(line.act() == 40ms);
  CHECK(line.turn[0] == 0x74);
  line.answer(power_up);
  CHECK(line.remote.spm_capabilities() == 7);
  CHECK(line.act() == 60ms);
  CHECK(line.turn[0] == 0x60);
  line.remote.is_silent = true;
  line.act();
  CHECK(line.turn.empty());
}

TEST_CASE("The remote takes in the SPM's general and times its answer", "[SB-01.1][SB-01.7][SB-2.7]") {
  Line line;
  line.bring_up();
  line.act();
  line.say(line.turn, line.remote.turn_began_at());
  line.answer({0x61, 0xB2, 0xC7, 0xA1, 0xA0, 0x80, 0x93, 0x9F, 0xB2, 0x0F});
  const SpmReport& report = line.remote.report();
  CHECK(report.fuel_gauge() == 18);
  CHECK(report.is_slowed());
  CHECK(report.is_drive_inhibited());
  CHECK_FALSE(report.is_power_down_now());
  CHECK(report.system_state() == 7);
  CHECK(report.is_drive_modified());
  CHECK(report.sounds_horn());
  CHECK(report.is_driving());
  CHECK(report.is_mode_invalid());
  CHECK(report.operating_mode() == 3);
  CHECK(report.speedo() == 31);
  CHECK(line.remote.statistics().answers == 1);
  CHECK(milliseconds(line.remote.statistics().median_delay()) == Approx(0.060).margin(0.0001));
  line.act();
  line.act();
  CHECK(line.remote.statistics().missed == 1);
  CHECK(line.remote.statistics().bad == 0);
}

TEST_CASE("What is spoiled, broken off or stray counts once and is not believed", "[SB-2.10]") {
  Line line;
  line.bring_up();
  line.act();
  SECTION("framing error") {
    line.remote.hear({0x61, true, line.remote.turn_ended_at() + 1ms});
    line.answer({0x0F});
  }
  SECTION("a new start byte too early") {
    line.answer({0x61, 0x80, 0x0F});
  }
  SECTION("strays") {
    line.answer({0x80, 0x81, 0x82, 0x0F});
  }
  SECTION("3 ms of silence") {
    line.answer({0x61, 0x80});
    line.say({0x80, 0x0F}, line.remote.turn_ended_at() + 6ms);
    CHECK(line.remote.statistics().bad == 2);
    return;
  }
  SECTION("a general too short") {
    line.answer({0x51, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0xAE, 0x0F});
  }
  CHECK(line.remote.statistics().bad == 1);
  CHECK(line.remote.statistics().answers == 0);
}

TEST_CASE("A second without an SPM general is a communications fault", "[SB-3.5]") {
  Line line;
  line.bring_up();
  while (line.remote.next_time() < 1000ms) {
    line.act();
  }
  CHECK_FALSE(line.remote.has_communication_fault());
  line.act();
  line.act();
  line.act();
  CHECK(line.remote.has_communication_fault());
  CHECK(line.turn[0] == 0x60);
  line.answer(quiet_general);
  CHECK_FALSE(line.remote.has_communication_fault());
}

TEST_CASE("The remote confirms power-down and goes off when the SPM has been silent", "[SB-4.3]") {
  Line line;
  line.bring_up();
  line.act();
  line.answer(power_down_general);
  const Time asked = line.remote.turn_ended_at();
  line.act();
  CHECK(line.turn == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x85, 0x80, 0xDB, 0x0F});
  Time now{};
  while (line.remote.is_on()) {
    now = line.act();
    REQUIRE(now < 2s);
  }
  CHECK(now - asked >= 500ms);
  CHECK(now - asked < 530ms);
  CHECK(line.remote.next_time() == Time::max());
}

TEST_CASE("Lamps and actuators are requested only when both sides have them", "[SB-3.6][SB-3.7]") {
  Line line;
  line.remote.start(0ms);
  line.remote.controls.headlight = true;
  line.remote.controls.mode = 2;
  line.act();
  SECTION("both") {
    line.answer(power_up);
    CHECK(line.remote.general_packet()[7] == 0x92);
  }
  SECTION("the power module has none") {
    line.answer({0x05, 0xA0, 0xDA, 0x0F});  // bit 5 is undocumented
    CHECK(line.remote.general_packet()[7] == 0x80);
  }
  SECTION("the remote has none") {
    line.remote.identity.capabilities = 0;
    line.answer(power_up);
    CHECK(line.remote.general_packet()[7] == 0x80);
  }
}

TEST_CASE("What the programmer types follows the general, at most eight characters a turn", "[SB-02.1][SB-2.2]") {
  Line line;
  line.remote.programmer.type("hello, SPM\r");
  line.remote.start(0ms);
  line.act();
  CHECK(line.turn[0] == 0x74);  // it waits until generals are sent
  CHECK(line.turn.size() == 11);
  line.answer(power_up);
  line.act();
  CHECK(line.turn == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC,                //
                           0x72, 0xE8, 0xE5, 0xEC, 0xEC, 0xEF, 0xAC, 0xA0, 0xD3, 0xDA, 0x0F});  // "hello, S"
  line.act();
  CHECK(line.turn == Bytes{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC,  //
                           0x22, 0xD0, 0xCD, 0x8D, 0xB3, 0x0F});                  // "PM\r"
  line.act();
  CHECK(line.turn.size() == 10);
}

TEST_CASE("Its keys 80 to 83 travel as 10 to 13", "[SB-02.2]") {
  Line line;
  line.bring_up();
  line.remote.programmer.type("\x80\x81\x82\x83\x7F");
  line.act();
  CHECK(Bytes(line.turn.begin() + 9, line.turn.end()) == Bytes{0x42, 0x90, 0x91, 0x92, 0x93, 0xFF, 0xF8, 0x0F});
}

TEST_CASE("What the power module sends to the programmer is shown in its codes", "[SB-03.1][SB-03.2]") {
  Line line;
  line.bring_up();
  line.act();
  line.answer({0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E,  //
               0x73, 0x8F, 0x90, 0x97, 0x98, 0x9F, 0xA0, 0xFF, 0x8D, 0xF3, 0x0F});
  CHECK(line.remote.programmer.screen() == "\x0F\x80\x87\xF8\xFF \x7F\r");
  CHECK(line.remote.statistics().bad == 0);
  CHECK(line.remote.statistics().unwanted == 0);
  CHECK(line.remote.statistics().answers == 1);
  line.remote.programmer.clear_screen();
  CHECK(line.remote.programmer.screen().empty());
}

TEST_CASE("A corrupt packet shows the programmer nothing", "[SB-03.1]") {
  Line line;
  line.bring_up();
  line.act();
  line.answer({0x03, 0xC1, 0xBA, 0x0F});
  CHECK(line.remote.programmer.screen().empty());
  CHECK(line.remote.statistics().bad == 1);
}

TEST_CASE("HHP data against the flow control are counted", "[SB-03.1]") {
  Line line;
  line.bring_up();
  line.remote.controls.hhp_may_send = false;
  line.act();
  CHECK(line.turn[6] == 0x80);
  line.remote.controls.hhp_may_send = true;  // not yet told
  line.answer({0x03, 0xC1, 0xBB, 0x0F});
  CHECK(line.remote.programmer.screen() == "A");
  CHECK(line.remote.statistics().unwanted == 1);
}

TEST_CASE("The remote's longest turn has 23 bytes", "[SB-2.2][SB-06.1]") {
  Line line;
  line.bring_up();
  line.remote.sends_calibration = true;
  line.remote.programmer.type("12345678");
  line.act();
  REQUIRE(line.turn.size() == 23);
  CHECK(Bytes(line.turn.begin() + 19, line.turn.end()) == Bytes{0x06, 0x80, 0xF9, 0x0F});
}

TEST_CASE("While calibration is active the remote tells how far it is", "[SB-06.1]") {
  Line line;
  line.bring_up();
  line.remote.controls.calibration_active = true;
  line.remote.controls.speed = 1000;
  line.remote.controls.direction = 20;
  line.act();
  CHECK(Bytes(line.turn.begin() + 9, line.turn.end()) == Bytes{0x06, 0x8A, 0xEF, 0x0F});
  line.remote.controls.speed = 20;
  line.remote.controls.direction = 1000;
  line.act();
  line.remote.controls.speed = line.remote.controls.direction = 500;
  line.act();
  CHECK(line.turn[10] == 0x9F);
  line.remote.controls.calibration_active = false;
  line.act();
  CHECK(line.turn.size() == 10);
}

TEST_CASE("A remote keeps its own bit rate, stop bits and gaps", "[SB-2.11]") {
  Line line;
  line.remote.timing.bit_us = 25;
  line.remote.timing.stop_bits = 1;
  line.remote.timing.gap = 1300us;
  line.remote.start(0ms);
  line.act();
  CHECK(line.starts[1] - line.starts[0] == 1550us);
  CHECK(line.starts[10] - line.starts[9] == 1550us);
  CHECK(line.remote.turn_ended_at() == line.starts[10] + 250us);
}

TEST_CASE("A turn longer than the period lets a beat pass") {
  Line line;
  line.bring_up();
  line.remote.timing.gap = 1300us;
  line.remote.sends_calibration = true;
  line.remote.programmer.type("12345678");
  CHECK(line.act() == 40ms);
  CHECK(line.turn.size() == 23);  // 35.2 ms
  CHECK(line.act() == 60ms);
  CHECK(line.turn.empty());
  CHECK(line.act() == 80ms);
  CHECK(line.turn.size() == 13);
  CHECK(line.remote.statistics().missed == 1);
}
