#include <catch2/catch.hpp>

#include <sstream>
#include <string>

#include "simulation/report/vcd.hpp"

namespace {

using namespace simulation;

constexpr Time bit = 26us;

std::string wave_of(const BusByte& byte) {
  report::Waveform waveform;
  waveform.on_byte(byte);
  std::ostringstream out;
  waveform.write(out);
  const std::string text = out.str();
  return text.substr(text.find("$dumpvars"));
}

// From the first edge on; the bus is '!'.
std::string edges_of(const BusByte& byte) {
  const std::string text = wave_of(byte);
  return text.substr(text.find("$end\n") + 5);
}

}  // namespace

TEST_CASE("the bus line of one character has its true edges") {
  // 0xC5 = 1100 0101, sent from the lowest bit: start 0, then 1 0 1 0 0 0 1 1, two stop bits.
  // In ticks of 100 ns: from 10000 on, 260 a bit.
  CHECK(edges_of({1ms, 1ms + 11 * bit, Sender::sr, 0xC5, 0xC5, false, false}) ==
        "#10000\n0!\n#10260\n1!\n#10520\n0!\n#10780\n1!\n#11040\n0!\n#11820\n1!\n#12860\n");
}

TEST_CASE("a spoiled character keeps the line down in its first stop bit") {
  // 0x00: start and eight zeros, and the stop bit after them, 10 bits down.
  CHECK(edges_of({1ms, 1ms + 11 * bit, Sender::noise, 0x00, 0x00, true, false}) == "#10000\n0!\n#12600\n1!\n#12860\n");
}

TEST_CASE("a character that never reached the line leaves no edge") {
  CHECK(edges_of({1ms, 1ms + 11 * bit, Sender::sr, 0x00, 0x00, false, true}) == "#12860\n");
}

TEST_CASE("before anything happens the bus is high and all else is low") {
  report::Waveform waveform;
  std::ostringstream out;
  waveform.write(out);
  CHECK_THAT(out.str(), Catch::Contains("$timescale 100 ns $end"));
  CHECK_THAT(out.str(), Catch::Contains("$var wire 1 ! bus $end"));
  CHECK_THAT(out.str(), Catch::Contains("$dumpvars\n1!\n0\"\n0#\n"));
}
