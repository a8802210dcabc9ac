#include "bus/shark/framer.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/support/wire_words.hpp"

namespace {

using namespace bus::shark;
using support::Bytes;
namespace wire = support::wire;
using What = Verdict::What;

// A stamp is taken at the first stop bit: the byte ends so many microseconds later.
constexpr unsigned until_end = 36;

// A receiver: characters 286 us apart, the clock asked every 500 us in between, everything added up.
struct Line {
  Framer framer;
  std::uint32_t now = 60000;  // near the wrap of the stamps, so that most tests cross it
  unsigned frames = 0;
  unsigned finished = 0;
  unsigned corrupt = 0;
  unsigned silences = 0;

  Verdict count(const Verdict& verdict) {
    frames += verdict.what == What::frame ? 1U : 0U;
    finished += verdict.what == What::finished ? 1U : 0U;
    corrupt += verdict.corrupt;
    silences += verdict.silence ? 1U : 0U;
    return verdict;
  }
  base::Stamp stamp() const { return base::Stamp(static_cast<std::uint16_t>(now)); }
  Verdict byte(std::uint8_t value, bool is_spoiled = false, unsigned after = 286) {
    now += after;
    return count(framer.feed(base::HeardByte{value, is_spoiled, stamp()}));
  }
  Verdict bytes(const Bytes& values) {
    Verdict last;
    for (const std::uint8_t value : values) {
      last = byte(value);
    }
    return last;
  }
  Verdict poll_after(unsigned span) {
    now += span;
    return count(framer.poll(stamp()));
  }
  void pause(unsigned span) {
    for (; span >= 500; span -= 500) {
      poll_after(500);
    }
    now += span;
  }
};

TEST_CASE("a sound packet becomes a frame with its type, length and data", "[SB-2.3][SB-2.4][SB-2.5]") {
  Line line;
  CHECK(line.bytes({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80}).what == What::nothing);
  CHECK(line.byte(0xC8).what == What::frame);
  const Frame& frame = line.framer.frame();
  CHECK(frame.is(Type::sr_general));
  CHECK(frame.length == 7);
  CHECK(frame.data[0] == 0x40);
  CHECK(frame.data[1] == 0x3F);
  CHECK(frame.data[2] == 0x7F);
  CHECK(frame.data[3] == 0x4D);
  CHECK(frame.data[4] == 0x00);
  CHECK(frame.data[5] == 0x0C);
  CHECK(frame.data[6] == 0x00);
  CHECK(line.corrupt == 0);
}

TEST_CASE("every packet captured from a real chair is sound", "[SB-2.3][SB-2.5]") {
  const Bytes packets[] = {
      {0x74, 0x82, 0x85, 0x82, 0x80, 0x88, 0xCD, 0xA0, 0x80, 0x8D},
      {0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1},
      {0x74, 0x81, 0x8D, 0x83, 0x80, 0x9A, 0xDF, 0xA7, 0x80, 0xDA},
      {0x05, 0x80, 0xFA},
      {0x05, 0x82, 0xF8},
      {0x05, 0xA0, 0xDA},
      {0x05, 0xA3, 0xD7},
      {0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8},
      {0x60, 0xC1, 0xBF, 0xFF, 0xC8, 0x80, 0xC4, 0x90, 0x84},
      {0x60, 0xFF, 0xC0, 0x80, 0xB2, 0x80, 0x84, 0x80, 0xAA},
      {0x60, 0x80, 0xC0, 0x80, 0xBF, 0x80, 0x84, 0x80, 0x9C},
      {0x60, 0x80, 0xB8, 0x80, 0x82, 0x80, 0x84, 0x81, 0xE0},
      {0x61, 0x80, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x9E},
      {0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC},
      {0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87, 0xFE},
      {0x1A, 0xA5, 0xA7, 0x99},
      {0x1A, 0x85, 0xA7, 0xB9},
      {0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C},
      {0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4},
  };
  Line line;
  for (const Bytes& packet : packets) {
    CHECK(line.bytes(packet).what == What::frame);
    CHECK(line.framer.frame().type == packet[0] % 16);
    CHECK(line.framer.frame().length == packet.size() - 2);
  }
  CHECK(line.corrupt == 0);
  CHECK(line.finished == 0);
}

TEST_CASE("packets of every type and length are framed", "[SB-2.3]") {
  for (unsigned type = 0; type < 16; ++type) {
    for (unsigned length = 1; length <= 8; ++length) {
      if (type == 15 && length == 1) {
        continue;  // TF
      }
      CAPTURE(type, length);
      Line line;
      CHECK(line.bytes(support::packet_of(type, length, 0xD5)).what == What::frame);
      CHECK(line.framer.frame().type == type);
      CHECK(line.framer.frame().length == length);
      for (std::uint8_t i = 0; i < length; ++i) {
        CHECK(line.framer.frame().data[i] == 0x55);
      }
      CHECK(line.corrupt == 0);
    }
  }
}

TEST_CASE("TF is one byte and ends the turn; type F with another length is a packet", "[SB-2.6]") {
  Line line;
  CHECK(line.byte(0x0F).what == What::finished);
  CHECK(line.bytes({0x1F, 0x80, 0x80, 0xE0}).what == What::frame);
  CHECK(line.framer.frame().type == 0x0F);
  CHECK(line.framer.frame().length == 2);
  CHECK(line.byte(0x0F).what == What::finished);
  CHECK(line.finished == 2);
  CHECK(line.corrupt == 0);
}

TEST_CASE("a wrong checksum makes one corrupt packet, whichever bit is wrong", "[SB-2.10][SB-2.5][H-05]") {
  for (unsigned bit = 0; bit < 7; ++bit) {
    Line line;
    Bytes packet = wire::at_rest;
    packet.back() = static_cast<std::uint8_t>(packet.back() ^ 1U << bit);
    CAPTURE(bit);
    CHECK(line.bytes(packet).what == What::nothing);
    CHECK(line.corrupt == 1);
    CHECK(line.frames == 0);
  }
}

TEST_CASE("no single flipped bit of a packet passes for the packet", "[SB-2.10][H-06]") {
  for (std::size_t at = 0; at < wire::forward_fast.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      Line line;
      Bytes packet = wire::forward_fast;
      packet[at] = static_cast<std::uint8_t>(packet[at] ^ 1U << bit);
      CAPTURE(at, bit);
      line.bytes(packet);
      line.pause(4000);
      CHECK(line.frames == 0);
      CHECK(line.corrupt >= 1);
      CHECK(line.corrupt <= 3);  // at worst: a packet cut off by a false start, the false packet, its strays
      line.bytes(wire::at_rest);
      CHECK(line.frames == 1);
    }
  }
}

TEST_CASE("a start byte inside a packet makes the old one corrupt and begins the new one", "[SB-2.10]") {
  for (std::size_t cut = 1; cut < wire::at_rest.size(); ++cut) {
    Line line;
    line.bytes(Bytes(wire::at_rest.begin(), wire::at_rest.begin() + static_cast<std::ptrdiff_t>(cut)));
    CAPTURE(cut);
    CHECK(line.corrupt == 0);
    CHECK(line.byte(wire::forward_fast[0]).corrupt == 1);
    CHECK(line.bytes(Bytes(wire::forward_fast.begin() + 1, wire::forward_fast.end())).what == What::frame);
    CHECK(line.corrupt == 1);
  }
}

TEST_CASE("TF inside a packet makes it corrupt and still ends the turn", "[SB-2.10][SB-2.6]") {
  Line line;
  line.bytes({0x60, 0xC0, 0xC0});
  const Verdict verdict = line.byte(0x0F);
  CHECK(verdict.corrupt == 1);
  CHECK(verdict.what == What::finished);
  CHECK(line.bytes(wire::at_rest).what == What::frame);
  CHECK(line.corrupt == 1);
}

TEST_CASE("a framing or overrun error anywhere in a packet makes exactly one corrupt packet", "[SB-2.10]") {
  for (std::size_t spoiled = 0; spoiled < wire::at_rest.size(); ++spoiled) {
    Line line;
    for (std::size_t i = 0; i < wire::at_rest.size(); ++i) {
      line.byte(wire::at_rest[i], i == spoiled);
    }
    CAPTURE(spoiled);
    CHECK(line.frames == 0);
    CHECK(line.corrupt == 1);
    CHECK(line.byte(0x0F).what == What::finished);
    CHECK(line.bytes(wire::at_rest).what == What::frame);
    CHECK(line.corrupt == 1);
  }
}

TEST_CASE("a spoiled TF does not end the turn", "[SB-2.10][SB-2.12]") {
  Line line;
  line.bytes(wire::at_rest);
  CHECK(line.byte(0x0F, true).what == What::nothing);
  CHECK(line.corrupt == 1);
  line.pause(4000);
  CHECK(line.silences == 1);
  CHECK(line.corrupt == 1);
}

TEST_CASE("a run of stray bytes is one corrupt packet, however long", "[SB-2.10]") {
  Line line;
  line.bytes(Bytes(50, 0xA5));
  CHECK(line.corrupt == 1);

  SECTION("a start byte ends it") {
    CHECK(line.bytes(wire::at_rest).what == What::frame);
    CHECK(line.corrupt == 1);
    line.byte(0x80);
    CHECK(line.corrupt == 2);
  }
  SECTION("TF ends it") {
    CHECK(line.byte(0x0F).what == What::finished);
    line.byte(0x80);
    CHECK(line.corrupt == 2);
  }
  SECTION("3.5 ms of silence end it") {
    line.pause(3500);
    line.byte(0x80);
    CHECK(line.corrupt == 2);
  }
  SECTION("2.5 ms of silence do not") {
    line.pause(2500);
    line.byte(0x80);
    CHECK(line.corrupt == 1);
  }
}

TEST_CASE("what follows the end of a sound packet without a start byte is stray", "[SB-2.10]") {
  Line line;
  line.bytes(wire::at_rest);
  line.bytes({0x80, 0x80});
  CHECK(line.frames == 1);
  CHECK(line.corrupt == 1);
}

TEST_CASE("a pause of 2.9 ms inside a packet is borne, one of 3.0 ms ends it", "[SB-2.11][SB-2.10]") {
  for (std::size_t gap_at = 1; gap_at < wire::at_rest.size(); ++gap_at) {
    CAPTURE(gap_at);
    Line patient;
    Line late;
    for (std::size_t i = 0; i < wire::at_rest.size(); ++i) {
      patient.byte(wire::at_rest[i], false, i == gap_at ? 2900 : 286);
      late.byte(wire::at_rest[i], false, i == gap_at ? 3000 + until_end : 286);
    }
    CHECK(patient.frames == 1);
    CHECK(patient.corrupt == 0);
    CHECK(patient.silences == 0);
    CHECK(late.frames == 0);
    CHECK(late.corrupt == 2);  // the packet, and its rest as a run of strays
    CHECK(late.silences == 1);
  }
}

TEST_CASE("the 3 ms start anew at each byte", "[SB-2.11]") {
  Line line;
  for (const std::uint8_t value : wire::at_rest) {
    line.pause(2500);
    line.byte(value);
  }
  CHECK(line.frames == 1);
  CHECK(line.corrupt == 0);
}

TEST_CASE("an unfinished packet is dropped between 3.0 and 3.5 ms after its last byte", "[SB-2.11]") {
  for (unsigned phase = 0; phase < 500; phase += 7) {
    Line line;
    line.bytes({0x60, 0xC0});
    const std::uint32_t last = line.now;
    line.poll_after(phase);
    while (line.corrupt == 0) {
      line.poll_after(500);
      REQUIRE(line.now - last < 4000);
    }
    CAPTURE(phase);
    CHECK(line.now - last >= 3000 + until_end);
    CHECK(line.now - last <= 3500 + until_end);
    CHECK(line.silences == 1);
  }
}

TEST_CASE("silence is told once, and only after something was heard", "[SB-2.12]") {
  Line line;
  line.pause(10000);
  CHECK(line.silences == 0);
  line.bytes(wire::at_rest);
  line.pause(200000);  // three wraps of the stamps
  CHECK(line.silences == 1);
  CHECK(line.corrupt == 0);
  line.byte(0x0F);
  line.pause(10000);
  CHECK(line.silences == 2);
}

TEST_CASE("a byte that comes after the silence ends it, even if the clock was not asked in between", "[SB-2.12]") {
  Line line;
  line.bytes(wire::at_rest);
  const Verdict verdict = line.byte(0x60, false, 3100);
  CHECK(verdict.silence);
  CHECK(line.bytes(Bytes(wire::at_rest.begin() + 1, wire::at_rest.end())).what == What::frame);
  CHECK(line.corrupt == 0);
}

TEST_CASE("a line held dominant is one corrupt packet, not many", "[SB-2.10][H-34]") {
  Line line;
  for (int i = 0; i < 1000; ++i) {
    line.byte(0x00, true);
  }
  CHECK(line.corrupt == 1);
  CHECK(line.frames == 0);
  CHECK(line.silences == 0);
}

TEST_CASE("a reset forgets the packet in progress without a verdict", "[SB-1.3]") {
  Line line;
  line.bytes({0x60, 0xC0, 0xC0});
  line.framer.reset();
  line.pause(10000);
  CHECK(line.corrupt == 0);
  CHECK(line.silences == 0);
  CHECK(line.bytes(wire::at_rest).what == What::frame);
}

TEST_CASE("a packet is nearly complete before its checksum, and neither long before nor after") {
  Line line;
  CHECK_FALSE(line.framer.is_nearly_complete());
  line.bytes({0x60, 0xC0, 0xC0, 0x80});
  CHECK_FALSE(line.framer.is_nearly_complete());
  line.bytes({0x80, 0x80, 0x80, 0x80});
  CHECK(line.framer.is_nearly_complete());
  line.byte(0x9F);
  CHECK_FALSE(line.framer.is_nearly_complete());
}

TEST_CASE("whatever came before, the next whole packet after a pause is understood", "[SB-2.10][SB-2.12]") {
  std::mt19937 generator(20);
  const auto random = [&generator](unsigned below) { return static_cast<unsigned>(generator() % below); };
  for (int round = 0; round < 2000; ++round) {
    Line line;
    const unsigned count = random(30);
    for (unsigned i = 0; i < count; ++i) {
      line.byte(static_cast<std::uint8_t>(random(256)), random(16) == 0, 286 + random(3500));
    }
    line.pause(3500);
    const unsigned corrupt = line.corrupt;
    CHECK(line.bytes(wire::forward_fast).what == What::frame);
    CHECK(line.framer.frame().data[0] == 0x7F);
    CHECK(line.corrupt == corrupt);
  }
}

}  // namespace
