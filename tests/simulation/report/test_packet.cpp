#include <catch2/catch.hpp>

#include <vector>

#include "simulation/report/packet.hpp"

namespace {

using namespace simulation;
using report::Packet;

constexpr Time character = 286us;

// Characters back to back, from `at` on.
std::vector<Packet> listen(const std::vector<std::uint8_t>& bytes, Time pause_before_last = {}) {
  std::vector<Packet> heard;
  report::Listener listener([&](const Packet& packet) { heard.push_back(packet); });
  Time at = 1ms;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    at += i + 1 == bytes.size() ? pause_before_last : Time{};
    listener.hear({at, at + character, Sender::sr, bytes[i], bytes[i], false, false});
    at += character;
  }
  listener.advance(at + 10ms);
  return heard;
}

}  // namespace

TEST_CASE("the listener tells packet and turn end apart", "[SB-2.3][SB-2.6]") {
  const auto heard = listen({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8, 0x0F});
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].is(bus::shark::Type::sr_general));
  CHECK(heard[0].data() == std::vector<std::uint8_t>{0x40, 0x3F, 0x7F, 0x4D, 0x00, 0x0C, 0x00});
  CHECK(heard[0].end - heard[0].start == 9 * character);
  CHECK(heard[1].kind == Packet::Kind::finished);
}

TEST_CASE("the listener calls a wrong checksum by its name", "[SB-2.5]") {
  const auto heard = listen({0x05, 0x82, 0xF9});
  REQUIRE(heard.size() == 1);
  CHECK(heard[0].kind == Packet::Kind::corrupt);
  CHECK(heard[0].flaw == "wrong checksum");
}

TEST_CASE("a start byte in mid-packet breaks the old packet off and begins the new one", "[SB-2.10]") {
  const auto heard = listen({0x60, 0xC0, 0x05, 0x82, 0xF8});
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].flaw == "broken off after 2 bytes");
  CHECK(heard[1].is(bus::shark::Type::spm_power_up));
}

TEST_CASE("3 ms of silence end a packet that is not complete", "[SB-2.11]") {
  CHECK(listen({0x05, 0x82, 0xF8}, 2900us).size() == 1);
  const auto heard = listen({0x05, 0x82, 0xF8}, 3ms);
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].flaw == "incomplete: 2 bytes, then silence");
  CHECK(heard[1].flaw == "outside any packet");
}

TEST_CASE("bytes with the marker outside any packet are one corrupt packet", "[SB-2.10]") {
  const auto heard = listen({0x81, 0x82, 0x83, 0x05, 0x82, 0xF8});
  REQUIRE(heard.size() == 2);
  CHECK(heard[0].bytes.size() == 3);
  CHECK(heard[1].is(bus::shark::Type::spm_power_up));
}

TEST_CASE("two who speak at once are told, whatever is heard of them", "[SB-2.18]") {
  std::vector<Packet> heard;
  report::Listener listener([&](const Packet& packet) { heard.push_back(packet); });
  listener.hear({1000us, 1286us, Sender::spm, 0x05, 0x05, false, false});
  listener.hear({1100us, 1386us, Sender::sacu, 0x69, 0x01, false, false});
  listener.hear({1286us, 1572us, Sender::spm, 0x82, 0x82, false, false});
  listener.advance(5ms);
  REQUIRE(heard.size() == 1);
  CHECK(heard[0].kind == Packet::Kind::corrupt);
  CHECK(heard[0].flaw == "two speak at once");
}

TEST_CASE("an answer that begins within a slow stop bit is no collision") {
  std::vector<Packet> heard;
  report::Listener listener([&](const Packet& packet) { heard.push_back(packet); });
  listener.hear({1000us, 1286us, Sender::sr, 0x0F, 0x0F, false, false});
  listener.hear({1270us, 1556us, Sender::spm, 0x0F, 0x0F, false, false});
  REQUIRE(heard.size() == 2);
  CHECK(heard[1].kind == Packet::Kind::finished);
}
