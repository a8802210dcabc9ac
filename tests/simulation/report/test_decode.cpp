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
