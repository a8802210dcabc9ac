// Golden packets of real chairs; the values beside them are those of the requirement catalogue.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "simulation/report/decode.hpp"

namespace {

using namespace simulation::report;

Decoded decode_bytes(const std::vector<std::uint8_t>& bytes) {
  Packet packet;
  packet.kind = Packet::Kind::packet;
  packet.bytes = bytes;
  return decode(packet);
}

std::string describe_bytes(const std::vector<std::uint8_t>& bytes) {
  return describe(decode_bytes(bytes));
}

}  // namespace

TEST_CASE("the power-up packet of a remote of 2006 reads as captured", "[SB-04.1][SB-04.3]") {
  CHECK(describe_bytes({0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1}) ==
        "remote type 2, year 2006, month 11, serial 4810, version 2.5, actuators, lighting");
}

TEST_CASE("the power-up packet of a remote of 2013 reads as captured", "[SB-04.1]") {
  CHECK(describe_bytes({0x74, 0x81, 0x8D, 0x83, 0x80, 0x9A, 0xDF, 0xA7, 0x80, 0xDA}) ==
        "remote type 1, year 2013, month 3, serial 3423, version 2.7");
}

TEST_CASE("a pre-release version says so", "[SB-04.3]") {
  CHECK(describe_bytes({0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0x99, 0x80, 0xF0}) ==
        "remote type 2, year 2006, month 11, serial 4810, version 1.1 pre-release");
}

TEST_CASE("real remote generals read as captured", "[SB-00.1][SB-00.2]") {
  CHECK(describe_bytes({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8}) ==
        "speed 513, direction 509, pot 255, remote inhibit, HHP may send, requested mode 0");
  CHECK(describe_bytes({0x60, 0xC1, 0xBF, 0xFF, 0xC8, 0x80, 0xC4, 0x90, 0x84}) ==
        "speed 521, direction 504, pot 255, hazard request, HHP may send, headlight request, requested mode 0");
  CHECK(describe_bytes({0x60, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x80, 0xAA}) ==
        "speed 1022, direction 514, pot 0, HHP may send, requested mode 0");
  CHECK(describe_bytes({0x60, 0x80, 0xC0, 0x80, 0xBF, 0x80, 0x84, 0x80, 0x9C}) ==
        "speed 7, direction 519, pot 0, HHP may send, requested mode 0");
  CHECK(describe_bytes({0x60, 0x80, 0xB8, 0x80, 0x82, 0x80, 0x84, 0x81, 0xE0}) ==
        "speed 0, direction 450, pot 0, HHP may send, requested mode 1");
}

TEST_CASE("real power module generals read as captured", "[SB-01.1][SB-01.2][SB-01.4][SB-01.7]") {
  CHECK(describe_bytes({0x61, 0x80, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x9E}) ==
        "fuel gauge 0, drive inhibited, lock mode enabled, mode 0, speedo 0");
  CHECK(describe_bytes({0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC}) ==
        "fuel gauge 18, lock mode enabled, system driving, mode 0, speedo 0");
  CHECK(describe_bytes({0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87, 0xFE}) ==
        "slowdown, fuel gauge 16, system state 09 Shark cable fault, lock mode enabled, system driving, mode 0, speedo "
        "7");
}

TEST_CASE("settings read as captured", "[SB-0A.2]") {
  CHECK(describe_bytes({0x1A, 0xA5, 0xA7, 0x99}) ==
        "speedo option, speed button sensitivity 5, joystick switch threshold 39");
}

TEST_CASE("an old remote's general has no mode", "[SB-00.3]") {
  CHECK(describe_bytes({0x50, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0xEC}) ==
        "speed 512, direction 512, pot 255, HHP may send");
}

TEST_CASE("the change view tells only what differs") {
  const auto before = decode_bytes({0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC});
  const auto limping = decode_bytes({0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87, 0xFE});
  CHECK(describe_change(before, limping) == "slowdown, fuel gauge 16, system state 09 Shark cable fault, speedo 7");
  CHECK(describe_change(limping, before) == "slowdown off, fuel gauge 18, system state 00 System OK, speedo 0");
  CHECK(describe_change(before, before).empty());
}

TEST_CASE("a type the document reserves is shown in hex", "[SB-5.1]") {
  const auto decoded = decode_bytes({0x0B, 0x80, 0xF4});
  CHECK(decoded.name == "type 0B");
  CHECK(describe(decoded) == "0B 80 F4");
}

TEST_CASE("the attendant control's packets read as captured", "[SB-08.1][SB-09.1]") {
  CHECK(describe_bytes({0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C}) ==
        "year 2010, month 9, serial 1545925, version 2.5, actuator 1");
  CHECK(describe_bytes({0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4}) ==
        "speed 512, direction 512, pot 255, attendant, requested mode 0");
  CHECK(describe_bytes({0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0xFB, 0x82, 0xEB}) ==
        "speed 512, direction 512, pot 255, joystick error, pot error, local fault, calibration active, non-critical "
        "fault, drive inhibit, requested mode 2");
}

TEST_CASE("programmer data are shown as characters", "[SB-02.1][SB-03.1]") {
  CHECK(describe_bytes({0x22, 0xD0, 0xCD, 0x8D, 0xB3}) == "\"PM\\r\"");
  CHECK(describe_bytes({0x43, 0xA2, 0x90, 0xDC, 0x8A, 0xFF, 0x8D}) == "\"\\\"\\x10\\\\\\n\\x7f\"");
  CHECK(decode_bytes({0x03, 0xC1, 0xBB}).name == "HHP data");
}

TEST_CASE("a calibration packet tells where the stick has been", "[SB-06.1]") {
  CHECK(describe_bytes({0x06, 0xBF, 0xBA}) ==
        "second pass, neutral seen, forward seen, reverse seen, left seen, right seen");
  CHECK(describe_bytes({0x06, 0x8A, 0xEF}) == "forward seen, left seen");
}

TEST_CASE("a factory test packet reads as a command", "[SB-07.1]") {
  CHECK(describe_bytes({0x27, 0xF5, 0x85, 0xC0, 0x9E}) == "command 05 write EEPROM, for the SACU, address 85, data C0");
  CHECK(describe_bytes({0x27, 0x89, 0x80, 0x80, 0xCF}) == "command 09 undefined, address 00, data 00");
}

TEST_CASE("every packet type of the document has its name and its fields", "[SB-5.3]") {
  for (int type = 0; type <= 0x0A; ++type) {
    const PacketRow* row = find_packet(static_cast<std::uint8_t>(type));
    REQUIRE(row != nullptr);
    CHECK(row->is_text == row->fields.empty());
  }
  CHECK(find_packet(0x0B) == nullptr);
}
