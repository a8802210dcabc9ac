// The EEPROM's layout as the simulation reads it: literal bytes, worked out by hand from docs/architecture.md.
#include "simulation/eeprom/layout.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace simulation::eeprom {
namespace {

Bytes erased() {
  return Bytes(4096, 0xFF);
}

void put(Bytes& contents, std::size_t at, const Bytes& bytes) {
  std::copy(bytes.begin(), bytes.end(), contents.begin() + static_cast<std::ptrdiff_t>(at));
}

// Mark, version 2, one value, sequence 7, 30; CRC-16/CCITT-FALSE over 02 01 07 1E 00.
const Bytes one_value{0x00, 0x02, 0x01, 0x07, 0x1E, 0x00, 0xD7, 0x86};

}  // namespace

TEST_CASE("a copy of the settings is sound if mark, version, count and checksum say so", "[H-20]") {
  Bytes contents = erased();
  put(contents, 128, one_value);
  const SettingsCopy copy = read_copy(contents, 1, 2, 1);
  CHECK(copy.is_marked);
  CHECK(copy.is_sound);
  CHECK(int(copy.sequence) == 7);
  CHECK(copy.values == Bytes{0x1E, 0x00});
  CHECK(make_copy({0x1E, 0x00}, 2, 7) == one_value);
  CHECK_FALSE(read_copy(contents, 0, 2, 1).is_marked);
  CHECK_FALSE(read_copy(contents, 1, 3, 1).is_sound);
  for (std::size_t at = 1; at < one_value.size(); ++at) {
    Bytes flipped = contents;
    flipped[128 + at] ^= 0x20;
    CHECK_FALSE(read_copy(flipped, 1, 2, 1).is_sound);
  }
}

TEST_CASE("of two sound copies the newer one is in force, of one sound copy that one, of none nothing", "[H-20]") {
  Bytes contents = erased();
  CHECK_FALSE(values_in_force(contents, 2, 1));
  put(contents, 128, one_value);
  CHECK(values_in_force(contents, 2, 1) == Bytes{0x1E, 0x00});
  put(contents, 0, make_copy({0x29, 0x00}, 2, 8));
  CHECK(values_in_force(contents, 2, 1) == Bytes{0x29, 0x00});
  put(contents, 0, make_copy({0x29, 0x00}, 2, 6));
  CHECK(values_in_force(contents, 2, 1) == Bytes{0x1E, 0x00});
  contents[128] = 0xFF;
  CHECK(values_in_force(contents, 2, 1) == Bytes{0x29, 0x00});
}

TEST_CASE("a record of the log is read as it lies there", "[H-20]") {
  Bytes contents = erased();
  // watchdog start, lap 1, 2 s, start 3; CRC-8 with polynomial 0x07
  put(contents, 2048 + 8 * 5, {0x01, 0x01, 0x01, 0x02, 0x00, 0x03, 0x00, 0x87});
  const auto record = read_record(contents, 5);
  REQUIRE(record);
  CHECK(record->code == 1);
  CHECK(record->argument == 1);
  CHECK(record->sequence == 261);
  CHECK(record->seconds == 2);
  CHECK(record->starts == 3);
  Bytes again = erased();
  write_record(again, *record);
  CHECK(again == contents);
  contents[2048 + 8 * 5 + 3] ^= 0x01;
  CHECK_FALSE(read_record(contents, 5));
  CHECK_FALSE(read_record(contents, 6));
}

TEST_CASE("the log is read from the oldest to the newest, also where its numbers begin again") {
  Bytes contents = erased();
  CHECK(read_log(contents).empty());
  CHECK_FALSE(newest_record(contents));
  write_record(contents, {65534, 1, 0, 0, 9});
  write_record(contents, {65535, 17, 0, 4, 9});
  write_record(contents, {0, 1, 0, 0, 10});
  const auto log = read_log(contents);
  REQUIRE(log.size() == 3);
  CHECK(log[0].sequence == 65534);
  CHECK(log[1].sequence == 65535);
  CHECK(log[2].sequence == 0);
  CHECK(newest_record(contents)->starts == 10);
}

}  // namespace simulation::eeprom
