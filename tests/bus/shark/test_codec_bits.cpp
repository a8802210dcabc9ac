// Every bit of every packet on its own: one bit is set, and exactly one value changes, by what that bit is worth. Bits
// that the document leaves unused change nothing. What each bit means is typed over from section 5, not from
// fields.hpp.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "bus/shark/codec.hpp"
#include "bus/shark/turn.hpp"
#include "tests/support/wire_words.hpp"

namespace {

using namespace bus::shark;
using support::Bytes;
using Values = std::vector<unsigned>;

// Bits `high` to `low` of data byte `byte` are bits `high - low + shift` to `shift` of value number `value`.
struct Meaning {
  unsigned byte;
  unsigned high;
  unsigned low;
  unsigned value;
  unsigned shift;
};

Frame frame_of(const Bytes& packet) {
  Frame frame;
  frame.type = packet[0] % 16;
  frame.length = static_cast<std::uint8_t>(packet[0] / 16 + 1);
  for (std::uint8_t i = 0; i < frame.length; ++i) {
    frame.data[i] = packet[i + 1U] % 128;
  }
  return frame;
}

Bytes packet_with_bit(unsigned type, unsigned length, unsigned byte, unsigned bit) {
  Bytes packet{static_cast<std::uint8_t>((length - 1) * 16 + type)};
  packet.insert(packet.end(), length, 0x80);
  packet[byte + 1] = static_cast<std::uint8_t>(0x80 + (1U << bit));
  return support::sealed(packet);
}

Values meant(const std::vector<Meaning>& meanings, std::size_t count, unsigned byte, unsigned bit) {
  Values values(count, 0);
  for (const Meaning& meaning : meanings) {
    if (meaning.byte == byte && bit <= meaning.high && bit >= meaning.low) {
      values[meaning.value] = 1U << (bit - meaning.low + meaning.shift);
    }
  }
  return values;
}

template <typename Read>
void walk(unsigned type, unsigned length, const std::vector<Meaning>& meanings, Read read) {
  const std::size_t count = read(frame_of(support::packet_of(type, length))).size();
  CHECK(read(frame_of(support::packet_of(type, length))) == Values(count, 0));
  for (unsigned byte = 0; byte < length; ++byte) {
    for (unsigned bit = 0; bit <= 6; ++bit) {
      CAPTURE(byte, bit);
      CHECK(read(frame_of(packet_with_bit(type, length, byte, bit))) == meant(meanings, count, byte, bit));
    }
  }
}

const std::vector<Meaning> joystick{
    {0, 6, 0, 0, 3}, {1, 6, 0, 1, 3}, {2, 6, 0, 2, 1}, {3, 6, 6, 2, 0}, {3, 5, 3, 0, 0}, {3, 2, 0, 1, 0},
};

std::vector<Meaning> operator+(std::vector<Meaning> first, const std::vector<Meaning>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST_CASE("every bit of an SR general means one thing, in a packet of 7 and of 8 data bytes",
          "[SB-00.1][SB-00.2][SB-5.2][00.0.6-0][00.1.6-0][00.2.6-0][00.3.6][00.3.5-3][00.3.2-0][00.4.6][00.4.5]"
          "[00.4.4][00.4.3][00.4.2][00.4.1][00.4.0][00.5.6][00.5.5][00.5.4][00.5.3][00.5.2][00.5.1][00.5.0][00.6.5]"
          "[00.6.4][00.6.3-0]") {
  const auto read = [](const Frame& frame) {
    const SrGeneral p = decode_sr_general(frame);
    return Values{p.speed.count(),
                  p.direction.count(),
                  p.pot.count(),
                  p.joystick_error,
                  p.pot_error,
                  p.local_fault,
                  p.charger_inhibit,
                  p.power_switch,
                  p.horn,
                  p.lock,
                  p.hazard_request,
                  p.left_request,
                  p.right_request,
                  p.remote_inhibit,
                  p.hhp_may_send,
                  p.calibration_active,
                  p.power_down_confirm,
                  p.non_critical_fault,
                  p.headlight_request,
                  p.requested_mode};
  };
  const std::vector<Meaning> meanings =
      joystick + std::vector<Meaning>{{4, 6, 6, 3, 0},  {4, 5, 5, 4, 0},  {4, 4, 4, 5, 0},  {4, 3, 3, 6, 0},
                                      {4, 2, 2, 7, 0},  {4, 1, 1, 8, 0},  {4, 0, 0, 9, 0},  {5, 6, 6, 10, 0},
                                      {5, 5, 5, 11, 0}, {5, 4, 4, 12, 0}, {5, 3, 3, 13, 0}, {5, 2, 2, 14, 0},
                                      {5, 1, 1, 15, 0}, {5, 0, 0, 16, 0}, {6, 5, 5, 17, 0}, {6, 4, 4, 18, 0},
                                      {6, 3, 0, 19, 0}};
  walk(0x0, 7, meanings, read);
  walk(0x0, 8, meanings, read);
}

TEST_CASE("every bit of an SR power-up packet means one thing",
          "[SB-04.1][04.0.6-0][04.1.6-0][04.2.3-0][04.3.6-0][04.4.6-0][04.5.6-0][04.6.6-0][04.7.1][04.7.0]") {
  const auto read = [](const Frame& frame) {
    const SrPowerUp p = decode_sr_power_up(frame);
    return Values{p.remote_type, p.year, p.month, p.serial, p.version, p.supports_actuators, p.supports_lighting};
  };
  walk(0x4, 8,
       {{0, 6, 0, 0, 0},
        {1, 6, 0, 1, 0},
        {2, 3, 0, 2, 0},
        {3, 6, 0, 3, 14},
        {4, 6, 0, 3, 7},
        {5, 6, 0, 3, 0},
        {6, 6, 0, 4, 0},
        {7, 1, 1, 5, 0},
        {7, 0, 0, 6, 0}},
       read);
}

TEST_CASE("every bit of HHP data is a bit of a character, in packets of 1 to 8", "[SB-02.1][SB-2.3]") {
  for (unsigned length = 1; length <= 8; ++length) {
    const auto read = [](const Frame& frame) {
      const HhpData p = decode_sr_hhp_data(frame);
      return Values(p.characters.begin(), p.characters.begin() + p.count);
    };
    std::vector<Meaning> meanings;
    for (unsigned byte = 0; byte < length; ++byte) {
      meanings.push_back({byte, 6, 0, byte, 0});
    }
    CHECK(read(frame_of(support::packet_of(0x2, length))).size() == length);
    walk(0x2, length, meanings, read);
  }
}

TEST_CASE("every bit of a joystick calibration packet means one thing, and bit 6 nothing",
          "[SB-06.1][SB-5.2][06.0.5][06.0.4][06.0.3][06.0.2][06.0.1][06.0.0]") {
  const auto read = [](const Frame& frame) {
    const JoystickCalibration p = decode_joystick_calibration(frame);
    return Values{p.second_pass, p.neutral_seen, p.forward_seen, p.reverse_seen, p.left_seen, p.right_seen};
  };
  for (unsigned length = 1; length <= 8; ++length) {
    walk(0x6, length,
         {{0, 5, 5, 0, 0}, {0, 4, 4, 1, 0}, {0, 3, 3, 2, 0}, {0, 2, 2, 3, 0}, {0, 1, 1, 4, 0}, {0, 0, 0, 5, 0}}, read);
  }
}

TEST_CASE("every bit of a factory test means one thing",
          "[SB-07.1][SB-5.2][07.0.6][07.0.5][07.0.4][07.0.3-0][07.1.6-0][07.2.6-0]") {
  const auto read = [](const Frame& frame) {
    const FactoryTest p = decode_factory_test(frame);
    return Values{p.is_for_sacu, p.command, p.address, p.data};
  };
  for (unsigned length = 3; length <= 8; ++length) {
    walk(0x7, length,
         {{0, 6, 6, 2, 7}, {0, 5, 5, 3, 7}, {0, 4, 4, 0, 0}, {0, 3, 0, 1, 0}, {1, 6, 0, 2, 0}, {2, 6, 0, 3, 0}}, read);
  }
}

TEST_CASE("every bit of a SACU general means one thing",
          "[SB-08.1][SB-5.2][08.0.6-0][08.1.6-0][08.2.6-0][08.3.6][08.3.5-3][08.3.2-0][08.4.6][08.4.5][08.4.4]"
          "[08.4.3][08.4.2][08.4.1][08.4.0][08.5.3-0]") {
  const auto read = [](const Frame& frame) {
    const SacuGeneral p = decode_sacu_general(frame);
    return Values{p.speed.count(),      p.direction.count(), p.pot.count(),        p.joystick_error,
                  p.pot_error,          p.local_fault,       p.calibration_active, p.attendant,
                  p.non_critical_fault, p.drive_inhibit,     p.requested_mode};
  };
  for (unsigned length = 6; length <= 8; ++length) {
    walk(0x8, length,
         joystick + std::vector<Meaning>{{4, 6, 6, 3, 0},
                                         {4, 5, 5, 4, 0},
                                         {4, 4, 4, 5, 0},
                                         {4, 3, 3, 6, 0},
                                         {4, 2, 2, 7, 0},
                                         {4, 1, 1, 8, 0},
                                         {4, 0, 0, 9, 0},
                                         {5, 3, 0, 10, 0}},
         read);
  }
}

TEST_CASE("every bit of a SACU power-up packet means one thing",
          "[SB-09.1][SB-5.2][09.0.6-0][09.1.3-0][09.2.6-0][09.3.6-0][09.4.6-0][09.5.6-0][09.6.2][09.6.1][09.6.0]") {
  const auto read = [](const Frame& frame) {
    const SacuPowerUp p = decode_sacu_power_up(frame);
    return Values{
        p.year, p.month, p.serial, p.version, p.supports_actuator2, p.supports_actuator1, p.has_speed_control};
  };
  for (unsigned length = 7; length <= 8; ++length) {
    walk(0x9, length,
         {{0, 6, 0, 0, 0},
          {1, 3, 0, 1, 0},
          {2, 6, 0, 2, 14},
          {3, 6, 0, 2, 7},
          {4, 6, 0, 2, 0},
          {5, 6, 0, 3, 0},
          {6, 2, 2, 4, 0},
          {6, 1, 1, 5, 0},
          {6, 0, 0, 6, 0}},
         read);
  }
}

// ---- what real modules say

TEST_CASE("the captured SACU packets mean what the capture says", "[SB-08.1][SB-09.1]") {
  const SacuPowerUp power_up = decode_sacu_power_up(frame_of({0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C}));
  CHECK(power_up.year == 10);
  CHECK(power_up.month == 9);
  CHECK(power_up.serial == 1545925);  // 94 * 16384 + 45 * 128 + 69
  CHECK(power_up.version == 0x25);
  CHECK_FALSE(power_up.supports_actuator2);
  CHECK(power_up.supports_actuator1);
  CHECK_FALSE(power_up.has_speed_control);

  const SacuGeneral general = decode_sacu_general(frame_of({0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4}));
  CHECK(general.speed.count() == 512);
  CHECK(general.direction.count() == 512);
  CHECK(general.pot.count() == 255);
  CHECK(general.attendant);
  CHECK_FALSE(general.joystick_error);
  CHECK_FALSE(general.pot_error);
  CHECK_FALSE(general.local_fault);
  CHECK_FALSE(general.calibration_active);
  CHECK_FALSE(general.non_critical_fault);
  CHECK_FALSE(general.drive_inhibit);
  CHECK(general.requested_mode == 0);
}

TEST_CASE("a SACU's joystick uses all 10 bits and its pot all 8", "[SB-08.1]") {
  for (unsigned value = 0; value < 1024; ++value) {
    const unsigned other = 1023 - value;
    const auto marked = [](unsigned bits) { return static_cast<std::uint8_t>(128 + bits); };
    const SacuGeneral general = decode_sacu_general(
        frame_of(support::sealed({0x58, marked(value / 8), marked(other / 8), marked(value % 256 / 2),
                                  marked(value % 2 * 64 + value % 8 * 8 + other % 8), 0x80, 0x80})));
    REQUIRE(general.speed.count() == value);
    REQUIRE(general.direction.count() == other);
    REQUIRE(general.pot.count() == value % 256);
  }
}

TEST_CASE("a factory test asks for what its bytes say", "[SB-07.1]") {
  // Write 0xA5 to register 0xC3 of the SACU: high bits of both, SACU, command 3.
  const FactoryTest write = decode_factory_test(frame_of({0x27, 0xF3, 0xC3, 0xA5, 0xFD}));
  CHECK(write.is_for_sacu);
  CHECK(write.command == 3);
  CHECK(write.address == 0xC3);
  CHECK(write.data == 0xA5);
  // Read EEPROM 0x10 of the SR.
  const FactoryTest read = decode_factory_test(frame_of({0x27, 0x82, 0x90, 0x80, 0xC6}));
  CHECK_FALSE(read.is_for_sacu);
  CHECK(read.command == 2);
  CHECK(read.address == 0x10);
  CHECK(read.data == 0);
}

// ---- what we say

Bytes wire_of(const Frame& frame) {
  Turn turn;
  turn.open();
  turn.add(frame);
  return Bytes(turn.bytes().begin(), turn.bytes().end());
}

TEST_CASE("HHP data goes out as its characters, marked, between start byte and checksum", "[SB-03.1][SB-2.4][SB-2.5]") {
  HhpData data;
  data.characters = {{'A', 'B', 'C', '\r', '\n', 0x00, 0x10, 0x7F}};
  data.count = 1;
  CHECK(wire_of(encode(data)) == Bytes{0x03, 0xC1, 0xBB});  // 03 + C1 = C4, of which 44 counts; 7F - 44 = 3B
  data.count = 5;
  CHECK(wire_of(encode(data)) == Bytes{0x43, 0xC1, 0xC2, 0xC3, 0x8D, 0x8A, 0xDF});
  data.count = 8;
  CHECK(wire_of(encode(data)) == Bytes{0x73, 0xC1, 0xC2, 0xC3, 0x8D, 0x8A, 0x80, 0x90, 0xFF, 0xA0});
}

TEST_CASE("every bit of every character goes out as itself", "[SB-03.1][SB-03.2]") {
  for (unsigned length = 1; length <= 8; ++length) {
    for (unsigned byte = 0; byte < length; ++byte) {
      for (unsigned bit = 0; bit <= 6; ++bit) {
        HhpData data;
        data.count = static_cast<std::uint8_t>(length);
        data.characters[static_cast<std::uint8_t>(byte)] = static_cast<std::uint8_t>(1U << bit);
        CHECK(wire_of(encode(data)) == packet_with_bit(0x3, length, byte, bit));
      }
    }
  }
}

TEST_CASE("every bit of the settings goes out as itself", "[SB-0A.2][SB-5.4][0A.0.5][0A.0.4][0A.0.3-0][0A.1.6-0]") {
  CHECK(wire_of(encode(SpmSettings{true, false, 0, 0})) == Bytes{0x1A, 0xA0, 0x80, 0xC5});
  CHECK(wire_of(encode(SpmSettings{false, true, 0, 0})) == Bytes{0x1A, 0x90, 0x80, 0xD5});
  for (unsigned bit = 0; bit <= 3; ++bit) {
    const auto value = static_cast<std::uint8_t>(1U << bit);
    CHECK(wire_of(encode(SpmSettings{false, false, value, 0})) == packet_with_bit(0xA, 2, 0, bit));
  }
  for (unsigned bit = 0; bit <= 6; ++bit) {
    const auto value = static_cast<std::uint8_t>(1U << bit);
    CHECK(wire_of(encode(SpmSettings{false, false, 0, value})) == packet_with_bit(0xA, 2, 1, bit));
  }
}

}  // namespace
