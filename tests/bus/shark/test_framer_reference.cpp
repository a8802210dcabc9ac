#include <catch2/catch.hpp>

#include "tests/bus/shark/framer_streams.hpp"

namespace {

using namespace reference;

// Back to back.
Stream record(const std::vector<std::uint8_t>& values) {
  Stream stream;
  for (const std::uint8_t value : values) {
    stream.push_back({value, false, 1000 + stream.size() * back_to_back});
  }
  return stream;
}

void delay(Stream& stream, std::size_t from, std::uint64_t gap) {
  const std::uint64_t by = gap - (stream[from].at - stream[from - 1].at);
  for (std::size_t i = from; i < stream.size(); ++i) {
    stream[i].at += by;
  }
}

int corrupt_in(const Reading& reading) {
  int sum = 0;
  for (const Outcome& outcome : reading.outcomes()) {
    sum += outcome.corrupt;
  }
  return sum;
}

// SR general of a real chair, settings of a real chair, TF.
const std::vector<std::uint8_t> conversation{0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C,
                                             0x80, 0xC8, 0x1A, 0xA5, 0xA7, 0x99, 0x0F};

// The judge is judged first, by literal bytes.
TEST_CASE("the reference framer reads an honest turn", "[SB-2.3][SB-2.4][SB-2.5][SB-2.6][SB-2.12]") {
  const Stream stream = record(conversation);
  const Reading reading(stream);
  CHECK(corrupt_in(reading) == 0);
  REQUIRE(reading.outcomes()[8].packet);
  CHECK(*reading.outcomes()[8].packet == Packet{0, {0x40, 0x3F, 0x7F, 0x4D, 0x00, 0x0C, 0x00}});
  REQUIRE(reading.outcomes()[12].packet);
  CHECK(*reading.outcomes()[12].packet == Packet{10, {0x25, 0x27}});
  CHECK(reading.outcomes()[13].finished);
  CHECK(reading.outcomes()[14].silence);
}

TEST_CASE("the reference framer finds each way to be corrupt once", "[SB-2.10][SB-2.11]") {
  Stream stream = record(conversation);
  SECTION("a wrong checksum") {
    stream[8].value = 0xC9;
    CHECK(corrupt_in(Reading(stream)) == 1);
    CHECK(Reading(stream).outcomes()[8].corrupt == 1);
  }
  SECTION("a start byte too early") {
    stream.erase(stream.begin() + 3);
    CHECK(corrupt_in(Reading(stream)) == 1);
    CHECK(Reading(stream).outcomes()[8].corrupt == 1);  // the settings' start byte, now in its place
    CHECK(Reading(stream).outcomes()[11].packet);
  }
  SECTION("a framing error") {
    stream[4].is_spoiled = true;
    CHECK(corrupt_in(Reading(stream)) == 1);
    CHECK(Reading(stream).outcomes()[4].corrupt == 1);
    CHECK(Reading(stream).outcomes()[12].packet);
  }
  SECTION("3 ms of silence; the rest is a run of strays") {
    delay(stream, 4, 3036);
    CHECK(Reading(stream).outcomes()[4].corrupt == 2);
    CHECK(corrupt_in(Reading(stream)) == 2);
  }
  SECTION("less than 3 ms are borne") {
    delay(stream, 4, 3035);
    CHECK(corrupt_in(Reading(stream)) == 0);
  }
  SECTION("strays behind a packet") {
    stream.insert(stream.begin() + 9, {{0x80, false, stream[8].at + 90}, {0xFF, false, stream[8].at + 180}});
    CHECK(corrupt_in(Reading(stream)) == 1);
    CHECK(Reading(stream).outcomes()[9].corrupt == 1);
  }
}

TEST_CASE("framer and reference agree on random and mutated streams",
          "[SB-2.3][SB-2.4][SB-2.5][SB-2.6][SB-2.10][SB-2.11][SB-2.12]") {
  for (std::uint64_t seed = 0; seed < 100'000; ++seed) {
    const Case played = make_case(seed);
    if (!do_agree(played)) {
      FAIL("seed " << seed << "\n" << tell(shrink(played)));
    }
  }
}

}  // namespace
