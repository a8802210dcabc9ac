#include "bus/shark/codec.hpp"

#include <catch2/catch.hpp>

#include "bus/shark/turn.hpp"
#include "tests/support/wire_words.hpp"

namespace {

using namespace bus::shark;
using support::Bytes;

// The frame a sound packet stands for: markers and checksum gone.
Frame frame_of(const Bytes& packet) {
  Frame frame;
  frame.type = packet[0] % 16;
  frame.length = static_cast<std::uint8_t>(packet[0] / 16 + 1);
  for (std::uint8_t i = 0; i < frame.length; ++i) {
    frame.data[i] = packet[i + 1U] % 128;
  }
  return frame;
}

SrGeneral general_of(const Bytes& packet) {
  return decode_sr_general(frame_of(packet));
}

// As it goes over the wire.
Bytes wire_of(const Frame& frame) {
  Turn turn;
  turn.open();
  turn.add(frame);
  return Bytes(turn.bytes().begin(), turn.bytes().end());
}
template <typename AnyPacket>
Bytes wire_of(const AnyPacket& packet) {
  return wire_of(encode(packet));
}

// ---- admission

TEST_CASE("types 0 to 15 with 1 to 8 data bytes are known, unknown or corrupt as the document's table says",
          "[SB-5.1][SB-5.2][SB-5.3]") {
  constexpr unsigned reserved = 0;
  //                              00               02            04     06 07 08 09
  constexpr unsigned least[16] = {6, reserved, 1, reserved, 6, reserved, 1, 3, 6, 7};
  for (unsigned type = 0; type < 16; ++type) {
    for (unsigned length = 1; length <= 8; ++length) {
      Frame frame;
      frame.type = static_cast<std::uint8_t>(type);
      frame.length = static_cast<std::uint8_t>(length);
      CAPTURE(type, length);
      if (least[type] == reserved) {
        CHECK(admit(frame) == Admission::unknown);
      } else if (length < least[type]) {
        CHECK(admit(frame) == Admission::corrupt);
      } else {
        CHECK(admit(frame) == Admission::known);
      }
    }
  }
}

// ---- type 00

TEST_CASE("a captured SR general at rest means what the capture says", "[SB-00.1][SB-00.2]") {
  const SrGeneral general = general_of({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8});
  CHECK(general.speed.count() == 513);
  CHECK(general.direction.count() == 509);
  CHECK(general.pot.count() == 255);
  CHECK(general.remote_inhibit);
  CHECK(general.hhp_may_send);
  CHECK(general.has_modes);
  CHECK(general.requested_mode == 0);
  CHECK_FALSE(general.joystick_error);
  CHECK_FALSE(general.charger_inhibit);
  CHECK_FALSE(general.power_down_confirm);
}

TEST_CASE("a captured SR general that asks for lights means what the capture says", "[SB-00.1][SB-00.2]") {
  const SrGeneral general = general_of({0x60, 0xC1, 0xBF, 0xFF, 0xC8, 0x80, 0xC4, 0x90, 0x84});
  CHECK(general.speed.count() == 521);
  CHECK(general.direction.count() == 504);
  CHECK(general.pot.count() == 255);
  CHECK(general.hazard_request);
  CHECK(general.headlight_request);
  CHECK(general.hhp_may_send);
  CHECK_FALSE(general.left_request);
  CHECK_FALSE(general.right_request);
  CHECK_FALSE(general.remote_inhibit);
}

TEST_CASE("captured SR generals at full stick mean what the capture says", "[SB-00.1][SB-00.8]") {
  const SrGeneral forward = general_of({0x60, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x80, 0xAA});
  CHECK(forward.speed.count() == 1022);
  CHECK(forward.direction.count() == 514);
  CHECK(forward.pot.count() == 0);
  const SrGeneral reverse = general_of({0x60, 0x80, 0xC0, 0x80, 0xBF, 0x80, 0x84, 0x80, 0x9C});
  CHECK(reverse.speed.count() == 7);
  CHECK(reverse.direction.count() == 519);
  CHECK(reverse.pot.count() == 0);
}

TEST_CASE("a captured SR general that asks for an actuator means what the capture says", "[SB-00.2]") {
  const SrGeneral general = general_of({0x60, 0x80, 0xB8, 0x80, 0x82, 0x80, 0x84, 0x81, 0xE0});
  CHECK(general.requested_mode == 1);
  CHECK(general.speed.count() == 0);
  CHECK(general.direction.count() == 450);
}

TEST_CASE("joystick readings use all 10 bits and the pot all 8", "[SB-00.1]") {
  for (unsigned value = 0; value < 1024; ++value) {
    const SrGeneral general = general_of(support::sr_general({value, 1023 - value, value % 256}));
    REQUIRE(general.speed.count() == value);
    REQUIRE(general.direction.count() == 1023 - value);
    REQUIRE(general.pot.count() == value % 256);
  }
}

struct Flag {
  const char* name;
  std::size_t byte;
  unsigned bit;
  bool SrGeneral::*member;
};

const Flag sr_flags[] = {
    {"joystick error", 4, 6, &SrGeneral::joystick_error},
    {"pot error", 4, 5, &SrGeneral::pot_error},
    {"local fault", 4, 4, &SrGeneral::local_fault},
    {"charger inhibit", 4, 3, &SrGeneral::charger_inhibit},
    {"power switch", 4, 2, &SrGeneral::power_switch},
    {"horn", 4, 1, &SrGeneral::horn},
    {"lock", 4, 0, &SrGeneral::lock},
    {"hazard", 5, 6, &SrGeneral::hazard_request},
    {"left", 5, 5, &SrGeneral::left_request},
    {"right", 5, 4, &SrGeneral::right_request},
    {"remote inhibit", 5, 3, &SrGeneral::remote_inhibit},
    {"HHP flow control", 5, 2, &SrGeneral::hhp_may_send},
    {"calibration active", 5, 1, &SrGeneral::calibration_active},
    {"power-down confirm", 5, 0, &SrGeneral::power_down_confirm},
    {"non-critical fault", 6, 5, &SrGeneral::non_critical_fault},
    {"headlight", 6, 4, &SrGeneral::headlight_request},
};

TEST_CASE("each bit of an SR general sets its own flag and no other", "[SB-00.2]") {
  for (const Flag& flag : sr_flags) {
    Bytes packet = support::wire::at_rest;
    packet[flag.byte + 1] = static_cast<std::uint8_t>(packet[flag.byte + 1] | 1U << flag.bit);
    const SrGeneral general = general_of(packet);
    for (const Flag& other : sr_flags) {
      CAPTURE(flag.name, other.name);
      CHECK(general.*other.member == (other.member == flag.member));
    }
    CHECK(general.requested_mode == 0);
    CHECK(general.speed.count() == 512);
  }
}

TEST_CASE("the requested operating mode is bits 3 to 0 of byte 6", "[SB-00.2][SB-00.7]") {
  for (unsigned mode = 0; mode < 16; ++mode) {
    CHECK(general_of(support::sr_general({.byte6 = mode})).requested_mode == mode);
    CHECK(general_of(support::sr_general({.byte6 = mode | 0x70})).requested_mode == mode);
  }
}

TEST_CASE("an old remote's general of 6 data bytes asks for drive mode and no lights", "[SB-00.3][H-32]") {
  Frame frame = frame_of({0x50, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0xBA});
  frame.data[6] = 0x7F;  // what an earlier packet left there
  const SrGeneral general = decode_sr_general(frame);
  CHECK_FALSE(general.has_modes);
  CHECK(general.requested_mode == 0);
  CHECK_FALSE(general.headlight_request);
  CHECK_FALSE(general.non_critical_fault);
  CHECK(general.speed.count() == 1022);
  CHECK(general.hhp_may_send);
}

TEST_CASE("what a longer general has to say beyond its 7 bytes is ignored", "[SB-5.2]") {
  const SrGeneral general = general_of({0x70, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x81, 0xFF, 0x9A});
  CHECK(general.speed.count() == 1022);
  CHECK(general.requested_mode == 1);
}

// ---- type 04

TEST_CASE("captured SR power-ups mean what the captures say", "[SB-04.1]") {
  const SrPowerUp first = decode_sr_power_up(frame_of({0x74, 0x82, 0x85, 0x82, 0x80, 0x88, 0xCD, 0xA0, 0x80, 0x8D}));
  CHECK(first.remote_type == 2);
  CHECK(first.year == 5);
  CHECK(first.month == 2);
  CHECK(first.serial == 1101);
  CHECK(first.version == 0x20);
  CHECK_FALSE(first.has_analog_pot);
  CHECK_FALSE(first.supports_actuators);
  CHECK_FALSE(first.supports_lighting);

  const SrPowerUp second = decode_sr_power_up(frame_of({0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1}));
  CHECK(second.remote_type == 2);
  CHECK(second.year == 6);
  CHECK(second.month == 11);
  CHECK(second.serial == 4810);
  CHECK(second.version == 0x25);
  CHECK(second.supports_actuators);
  CHECK(second.supports_lighting);
  CHECK_FALSE(second.has_analog_pot);

  const SrPowerUp third = decode_sr_power_up(frame_of({0x74, 0x81, 0x8D, 0x83, 0x80, 0x9A, 0xDF, 0xA7, 0x80, 0xDA}));
  CHECK(third.remote_type == 1);
  CHECK(third.year == 13);
  CHECK(third.month == 3);
  CHECK(third.serial == 3423);
  CHECK(third.version == 0x27);
  CHECK_FALSE(third.supports_actuators);
  CHECK_FALSE(third.supports_lighting);
}

TEST_CASE("a serial number has 21 bits, highest first", "[SB-04.1]") {
  Frame frame = frame_of(support::wire::sr_power_up);
  frame.data[3] = 0x7F;
  frame.data[4] = 0x7F;
  frame.data[5] = 0x7F;
  CHECK(decode_sr_power_up(frame).serial == 2097151);
  frame.data[3] = 0x40;
  frame.data[4] = 0x02;
  frame.data[5] = 0x03;
  CHECK(decode_sr_power_up(frame).serial == 1048576 + 256 + 3);
}

TEST_CASE("a month is only the low 4 bits of its byte", "[SB-04.1]") {
  Frame frame = frame_of(support::wire::sr_power_up);
  frame.data[2] = 0x7C;
  CHECK(decode_sr_power_up(frame).month == 12);
}

TEST_CASE("with fewer than 8 data bytes a remote has neither actuators, lighting nor pot", "[SB-04.2][H-32]") {
  for (std::uint8_t length = 6; length <= 8; ++length) {
    Frame frame = frame_of(support::wire::sr_power_up);
    frame.data[6] = 0x27;
    frame.data[7] = 0x07;
    frame.length = length;
    const SrPowerUp packet = decode_sr_power_up(frame);
    CAPTURE(int(length));
    CHECK(packet.version == (length >= 7 ? 0x27 : 0));
    CHECK(packet.supports_actuators == (length == 8));
    CHECK(packet.supports_lighting == (length == 8));
    CHECK(packet.has_analog_pot == (length == 8));
  }
}

TEST_CASE("each capability is its own bit", "[SB-04.1][04.7.2][04.7.1][04.7.0]") {
  Frame frame = frame_of(support::wire::sr_power_up);
  frame.data[6] = 0x30;
  frame.data[7] = 0x01;
  CHECK(decode_sr_power_up(frame).supports_lighting);
  CHECK_FALSE(decode_sr_power_up(frame).supports_actuators);
  CHECK_FALSE(decode_sr_power_up(frame).has_analog_pot);
  frame.data[7] = 0x02;
  CHECK_FALSE(decode_sr_power_up(frame).supports_lighting);
  CHECK(decode_sr_power_up(frame).supports_actuators);
  CHECK_FALSE(decode_sr_power_up(frame).has_analog_pot);
  frame.data[7] = 0x78 | 0x04;
  CHECK_FALSE(decode_sr_power_up(frame).supports_lighting);
  CHECK_FALSE(decode_sr_power_up(frame).supports_actuators);
  CHECK(decode_sr_power_up(frame).has_analog_pot);
}

TEST_CASE("the pot bit counts from version 2.5 on, pre-release or not", "[SB-04.2][04.7.2]") {
  const auto honours_pot = [](int version) {
    Frame frame = frame_of(support::wire::sr_power_up);
    frame.data[6] = static_cast<std::uint8_t>(version);
    frame.data[7] = 0x04;
    return decode_sr_power_up(frame).has_analog_pot;
  };
  for (const int older : {0x00, 0x01, 0x02, 0x10, 0x17, 0x1F, 0x20, 0x24, 0x2C}) {
    CAPTURE(older);
    CHECK_FALSE(honours_pot(older));
  }
  for (const int newer : {0x25, 0x2D, 0x26, 0x27, 0x2F, 0x30, 0x38, 0x77, 0x7F}) {
    CAPTURE(newer);
    CHECK(honours_pot(newer));
  }
}

// ---- type 01

TEST_CASE("an SPM general that inhibits driving goes out as captured", "[SB-01.1][SB-01.2][SB-01.3][SB-2.5]") {
  SpmGeneral general;
  general.drive_inhibited = true;
  general.lock_mode_enabled = true;
  CHECK(wire_of(general) == Bytes{0x61, 0x80, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x9E});
}

TEST_CASE("an SPM general of a driving chair goes out as captured", "[SB-01.1][SB-01.4][SB-2.5]") {
  SpmGeneral general;
  general.fuel_gauge = 18;
  general.lock_mode_enabled = true;
  general.system_driving = true;
  CHECK(wire_of(general) == Bytes{0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC});
}

TEST_CASE("an SPM general in LIMP goes out as captured", "[SB-01.1][SB-01.2][SB-01.7][SB-01.9][SB-2.5]") {
  SpmGeneral general;
  general.fuel_gauge = 16;
  general.slowdown = true;
  general.system_state = SystemState::cable;
  general.lock_mode_enabled = true;
  general.system_driving = true;
  general.speedo = 7;
  CHECK(wire_of(general) == Bytes{0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87, 0xFE});
}

struct Bit {
  const char* name;
  std::size_t byte;
  unsigned bit;
  bool SpmGeneral::*member;
};

const Bit spm_bits[] = {
    {"lock status", 0, 6, &SpmGeneral::locked},
    {"slowdown", 0, 5, &SpmGeneral::slowdown},
    {"drive inhibited", 1, 6, &SpmGeneral::drive_inhibited},
    {"display disable", 1, 5, &SpmGeneral::display_disabled},
    {"power down now", 1, 4, &SpmGeneral::power_down_now},
    {"lock mode enable", 2, 6, &SpmGeneral::lock_mode_enabled},
    {"SR temporary drive modification", 2, 5, &SpmGeneral::sr_drive_modified},
    {"joystick wake-up allowed", 2, 4, &SpmGeneral::joystick_wakes},
    {"sleep requested", 2, 3, &SpmGeneral::sleep_requested},
    {"joystick calibration mode", 2, 2, &SpmGeneral::calibration_mode},
    {"sound horn", 2, 0, &SpmGeneral::sound_horn},
    {"SACU is driving control", 3, 6, &SpmGeneral::sacu_drives},
    {"system is driving", 3, 5, &SpmGeneral::system_driving},
    {"flash cadence", 3, 4, &SpmGeneral::flash_cadence},
    {"hazard status", 3, 3, &SpmGeneral::hazard_on},
    {"left status", 3, 2, &SpmGeneral::left_on},
    {"right status", 3, 1, &SpmGeneral::right_on},
    {"headlight status", 3, 0, &SpmGeneral::headlight_on},
    {"SACU calibration mode", 4, 6, &SpmGeneral::sacu_calibration_mode},
    {"SACU temporary drive modification", 4, 5, &SpmGeneral::sacu_drive_modified},
    {"SACU power-up acknowledge", 4, 4, &SpmGeneral::sacu_acknowledged},
    {"hazard fault", 4, 3, &SpmGeneral::hazard_fault},
    {"left fault", 4, 2, &SpmGeneral::left_fault},
    {"right fault", 4, 1, &SpmGeneral::right_fault},
    {"headlight fault", 4, 0, &SpmGeneral::headlight_fault},
    {"actuator 2 fault", 5, 6, &SpmGeneral::actuator2_fault},
    {"actuator 1 fault", 5, 5, &SpmGeneral::actuator1_fault},
    {"SR mode invalid", 5, 4, &SpmGeneral::sr_mode_invalid},
    {"SACU mode invalid", 6, 5, &SpmGeneral::sacu_mode_invalid},
};

TEST_CASE("each flag of an SPM general goes out as its own bit and no other",
          "[SB-01.1][SB-01.2][SB-01.3][SB-01.4][SB-01.5][SB-01.6][SB-01.7][SB-5.4][01.0.6][01.0.5][01.1.6][01.1.5]"
          "[01.1.4][01.2.6][01.2.5][01.2.4][01.2.3][01.2.2][01.2.0][01.3.6][01.3.5][01.3.4][01.3.3][01.3.2][01.3.1]"
          "[01.3.0][01.4.6][01.4.5][01.4.4][01.4.3][01.4.2][01.4.1][01.4.0][01.5.6][01.5.5][01.5.4][01.6.5]") {
  for (const Bit& bit : spm_bits) {
    SpmGeneral general;
    general.*bit.member = true;
    Bytes expected{0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80};
    expected[bit.byte + 1] = static_cast<std::uint8_t>(0x80 | 1U << bit.bit);
    CAPTURE(bit.name);
    CHECK(wire_of(general) == support::sealed(expected));
  }
}

TEST_CASE("the numbers of an SPM general go out in their own bits",
          "[SB-01.1][SB-01.2][SB-01.6][SB-01.7][01.0.4-0][01.1.3-0][01.5.3-0][01.6.4-0]") {
  for (unsigned value = 0; value < 32; ++value) {
    const auto small = static_cast<std::uint8_t>(value);
    const auto with_marker = static_cast<std::uint8_t>(0x80 + value);
    SpmGeneral gauge;
    gauge.fuel_gauge = small;
    CHECK(wire_of(gauge) == support::sealed({0x61, with_marker, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80}));
    SpmGeneral speedo;
    speedo.speedo = small;
    CHECK(wire_of(speedo) == support::sealed({0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, with_marker}));
    if (value < 16) {
      SpmGeneral mode;
      mode.operating_mode = small;
      CHECK(wire_of(mode) == support::sealed({0x61, 0x80, 0x80, 0x80, 0x80, 0x80, with_marker, 0x80}));
      SpmGeneral state;
      state.system_state = static_cast<SystemState>(small);
      CHECK(wire_of(state) == support::sealed({0x61, 0x80, with_marker, 0x80, 0x80, 0x80, 0x80, 0x80}));
    }
  }
}

TEST_CASE("the system states have the document's numbers", "[SB-01.9]") {
  CHECK(static_cast<int>(SystemState::ok) == 0x0);
  CHECK(static_cast<int>(SystemState::user) == 0x1);
  CHECK(static_cast<int>(SystemState::battery) == 0x2);
  CHECK(static_cast<int>(SystemState::left_motor) == 0x3);
  CHECK(static_cast<int>(SystemState::right_motor) == 0x4);
  CHECK(static_cast<int>(SystemState::left_brake) == 0x5);
  CHECK(static_cast<int>(SystemState::right_brake) == 0x6);
  CHECK(static_cast<int>(SystemState::remote) == 0x7);
  CHECK(static_cast<int>(SystemState::power_module) == 0x8);
  CHECK(static_cast<int>(SystemState::cable) == 0x9);
  CHECK(static_cast<int>(SystemState::unknown) == 0xA);
}

// ---- types 05 and 0A

TEST_CASE("SPM power-ups go out as captured, less the undocumented bit 5", "[SB-05.1][05.0.2][05.0.1][05.0.0]") {
  CHECK(wire_of(SpmPowerUp{}) == Bytes{0x05, 0x80, 0xFA});
  CHECK(wire_of(SpmPowerUp{false, true, false}) == Bytes{0x05, 0x82, 0xF8});
  CHECK(wire_of(SpmPowerUp{true, false, false}) == Bytes{0x05, 0x84, 0xF6});
  CHECK(wire_of(SpmPowerUp{false, false, true}) == Bytes{0x05, 0x81, 0xF9});
  CHECK(wire_of(SpmPowerUp{true, true, true}) == Bytes{0x05, 0x87, 0xF3});
}

TEST_CASE("settings packets go out as captured", "[SB-0A.2][SB-2.5]") {
  CHECK(wire_of(SpmSettings{true, false, 5, 39}) == Bytes{0x1A, 0xA5, 0xA7, 0x99});
  CHECK(wire_of(SpmSettings{false, false, 5, 39}) == Bytes{0x1A, 0x85, 0xA7, 0xB9});
}

TEST_CASE("each field of a settings packet goes out in its own bits", "[SB-0A.2]") {
  CHECK(wire_of(SpmSettings{false, true, 1, 1}) == support::sealed({0x1A, 0x91, 0x81}));
  CHECK(wire_of(SpmSettings{true, true, 10, 100}) == support::sealed({0x1A, 0xBA, 0xE4}));
}

}  // namespace
