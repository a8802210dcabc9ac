#include <catch2/catch.hpp>

#include <vector>

#include "simulation/report/transcript.hpp"

namespace {

using namespace simulation;
using report::Transcript;

void say(Transcript& transcript, Sender sender, Time at, const std::vector<std::uint8_t>& bytes) {
  for (const std::uint8_t byte : bytes) {
    transcript.on_byte({at, at + 286us, sender, byte, byte, false, false});
    at += 286us;
  }
}

// Two cycles; the power module answers `answer` in the second, `delay` after the remote's TF.
Transcript two_cycles(Time delay, const std::vector<std::uint8_t>& answer) {
  Transcript transcript;
  say(transcript, Sender::noise, 5ms, {0x00});
  say(transcript, Sender::sr, 10ms, {0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8, 0x0F});
  say(transcript, Sender::sr, 30ms, {0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8, 0x0F});
  say(transcript, Sender::spm, 32860us + delay, answer);
  return transcript;
}

}  // namespace

TEST_CASE("a cycle begins with the remote's first byte") {
  const auto transcript = two_cycles(20us, {0x05, 0x80, 0xFA, 0x0F});
  REQUIRE(transcript.cycles().size() == 3);
  CHECK(transcript.cycles()[0].bytes.size() == 1);
  CHECK(transcript.cycles()[1].bytes.size() == 10);
  CHECK(transcript.cycles()[2].bytes.size() == 14);
  CHECK(transcript.byte_count() == 25);
}

TEST_CASE("timing is not compared") {
  const auto early = two_cycles(0us, {0x05, 0x80, 0xFA, 0x0F});
  const auto late = two_cycles(90us, {0x05, 0x80, 0xFA, 0x0F});
  CHECK(early.hash() == late.hash());
  CHECK_FALSE(report::first_difference({"avr", early}, {"host", late}));
}

TEST_CASE("another byte is a difference, shown decoded from both sides") {
  const auto one = two_cycles(0us, {0x05, 0x80, 0xFA, 0x0F});
  const auto other = two_cycles(0us, {0x05, 0x82, 0xF8, 0x0F});
  CHECK(one.hash() != other.hash());
  const auto difference = report::first_difference({"avr", one}, {"host", other});
  REQUIRE(difference);
  CHECK_THAT(*difference, Catch::StartsWith("cycle 2 differs"));
  CHECK_THAT(*difference, Catch::Contains("05 80 FA"));
  CHECK_THAT(*difference, Catch::Contains("actuator 1"));
}

TEST_CASE("another sender or a cycle more is a difference, too") {
  const auto one = two_cycles(0us, {0x0F});
  auto with_more = one;
  say(with_more, Sender::sr, 50ms, {0x0F});
  CHECK(one.hash() != with_more.hash());
  CHECK(report::first_difference({"avr", one}, {"host", with_more}));

  Transcript by_sr;
  Transcript by_noise;
  say(by_sr, Sender::spm, 1ms, {0x0F});
  say(by_noise, Sender::noise, 1ms, {0x0F});
  CHECK(by_sr.hash() != by_noise.hash());
  CHECK(report::first_difference({"avr", by_sr}, {"host", by_noise}));
}

TEST_CASE("the hash is FNV-1a over cycle marks, senders and bytes") {
  // Empty cycle 0 only: one 0xFF. FNV-1a 64 of the single byte FF is AF64724C8602EB6E.
  CHECK(Transcript().hash() == 0xAF64724C8602EB6EU);
}
