#include "spm/event_log.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/support/eeprom.hpp"

namespace {

using namespace support;
using Bytes = std::vector<std::uint8_t>;

Bytes bytes_at(const Eeprom& eeprom, std::size_t address, std::size_t count) {
  return {eeprom.begin() + static_cast<std::ptrdiff_t>(address),
          eeprom.begin() + static_cast<std::ptrdiff_t>(address + count)};
}

// The textbook's way, so that it shares nothing with the product.
unsigned textbook_crc8(const Bytes& message) {
  unsigned crc = 0;
  for (const unsigned byte : message) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x80U) != 0 ? (crc << 1 & 0xFFU) ^ 0x07U : crc << 1;
    }
  }
  return crc;
}

// Starts, writes `code` and goes off.
void live(Eeprom& eeprom, std::uint8_t code) {
  Started module(eeprom);
  module.note(code);
  module.write_all(eeprom);
}

TEST_CASE("the first record of a new board stands at 2048", "[SB-3.9]") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  module.note(1, 0);
  CHECK(module.storage.is_pending());
  module.write_all(eeprom);
  CHECK_FALSE(module.storage.is_pending());
  CHECK(bytes_at(eeprom, 2048, 9) == Bytes{0x01, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0xCA, 0xFF});
}

TEST_CASE("a record holds code, argument, lap, seconds, starts and CRC-8") {
  CHECK(textbook_crc8({'1', '2', '3', '4', '5', '6', '7', '8', '9'}) == 0xF4);
  spm::LogRecord record;
  record.sequence = 0x1203;
  record.code = 0x11;
  record.argument = 0xA7;
  record.seconds = 0x0234;
  record.starts = 0x01C8;
  const spm::RecordBytes made = spm::make_record(record);
  Bytes bytes(made.begin(), made.end());
  const unsigned check = bytes.back();
  bytes.pop_back();
  CHECK(bytes == Bytes{0x11, 0xA7, 0x12, 0x34, 0x02, 0xC8, 0x01});
  CHECK(check == textbook_crc8(bytes));
  const auto read = spm::read_record(made, 0x03);
  REQUIRE(read.has_value());
  CHECK(read->sequence == 0x1203);
  CHECK(read->code == 0x11);
  CHECK(read->argument == 0xA7);
  CHECK(read->seconds == 0x0234);
  CHECK(read->starts == 0x01C8);
}

TEST_CASE("erased places, zeros and any flipped bit are no record", "[H-20]") {
  spm::RecordBytes zeros{};
  CHECK_FALSE(spm::read_record(zeros, 0).has_value());
  spm::RecordBytes erased{};
  for (std::uint8_t& byte : erased) {
    byte = 0xFF;
  }
  CHECK_FALSE(spm::read_record(erased, 0).has_value());
  spm::LogRecord record;
  record.code = 17;
  record.starts = 5;
  for (std::uint8_t at = 0; at < 8; ++at) {
    for (unsigned mixed = 1; mixed < 256; ++mixed) {
      spm::RecordBytes bytes = spm::make_record(record);
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ mixed);
      REQUIRE_FALSE(spm::read_record(bytes, 0).has_value());
    }
  }
}

TEST_CASE("a record takes nine bytes: the old code away, the rest, the code last", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  module.note(16, 3);
  const auto writes = module.write_all(eeprom);
  REQUIRE(writes.size() == 9);
  CHECK(writes[0].address == 2048);
  CHECK(writes[0].value == 0xFF);
  for (std::size_t i = 1; i < 8; ++i) {
    CHECK(writes[i].address == 2048 + i);
  }
  CHECK(writes[8].address == 2048);
  CHECK(writes[8].value == 16);
}

TEST_CASE("each start goes on behind the newest record and counts itself") {
  Eeprom eeprom = erased_eeprom();
  for (unsigned start = 1; start <= 600; ++start) {  // more than twice round
    live(eeprom, 1);
    const auto newest = spm::read_record(place_in(eeprom, (start - 1) % 256), static_cast<std::uint8_t>(start - 1));
    REQUIRE(newest.has_value());
    REQUIRE(newest->sequence == start - 1);
    REQUIRE(newest->starts == start);
  }
}

TEST_CASE("the newest is found across the wrap of the sequence number") {
  Eeprom eeprom = erased_eeprom();
  for (unsigned i = 0; i < 256; ++i) {  // 65400 to 65535, and on with 0
    spm::LogRecord record;
    record.sequence = static_cast<std::uint16_t>(65400 + i);
    record.code = 5;
    record.starts = static_cast<std::uint16_t>(i);
    const spm::RecordBytes bytes = spm::make_record(record);
    std::copy(bytes.begin(), bytes.end(), eeprom.begin() + 2048 + 8 * (record.sequence & 0xFF));
  }
  const Started module(eeprom);
  CHECK(int(module.storage.log().next_place()) == 120);  // 65400 + 256 = 65536 + 120
  CHECK(module.storage.log().starts() == 256);
}

TEST_CASE("before it has looked through the ring nothing is written, and events wait") {
  spm::EventLog log;
  log.add(1, 0);
  const spm::RecordBytes nothing{};
  for (int i = 0; i < 255; ++i) {
    log.look(nothing);
    CHECK(log.is_looking());
    REQUIRE_FALSE(log.next_write().has_value());
    REQUIRE(log.is_pending());
  }
  log.look(nothing);
  CHECK_FALSE(log.is_looking());
  CHECK(log.next_write().has_value());
}

TEST_CASE("the same event is written once within 60 s, another one at once") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  const auto is_written = [&](std::uint8_t code) {
    module.note(code);
    return !module.write_all(eeprom).empty();
  };
  CHECK(is_written(16));
  CHECK_FALSE(is_written(16));
  CHECK(is_written(17));
  module.seconds(60);
  CHECK_FALSE(is_written(16));  // 60 s at least, 61 at most
  module.seconds(1);
  CHECK(is_written(16));
  CHECK_FALSE(is_written(16));
}

TEST_CASE("a chattering fault costs one record a minute") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  std::size_t bytes = 0;
  for (int second = 0; second < 610; ++second) {
    for (int i = 0; i < 10; ++i) {
      module.note(16, static_cast<std::uint8_t>(i));
      bytes += module.write_all(eeprom).size();
    }
    module.seconds(1);
  }
  CHECK(bytes == 10 * 9);
}

TEST_CASE("a record tells the second it happened in; 65535 is that or later") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  module.seconds(300);
  module.note(6);
  module.write_all(eeprom);
  CHECK(bytes_at(eeprom, 2048, 7) == Bytes{0x06, 0x00, 0x00, 0x2C, 0x01, 0x01, 0x00});
  module.seconds(70000);
  module.note(6);
  module.write_all(eeprom);
  CHECK(bytes_at(eeprom, 2056, 7) == Bytes{0x06, 0x00, 0x00, 0xFF, 0xFF, 0x01, 0x00});
}

TEST_CASE("four events may wait; a fifth is dropped, and may be written later") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  for (const int code : {2, 3, 4, 5, 7}) {
    module.note(static_cast<std::uint8_t>(code));
  }
  CHECK(module.write_all(eeprom).size() == 4 * 9);
  module.note(7);
  CHECK(module.write_all(eeprom).size() == 9);
}

TEST_CASE("codes that the log does not know are not written") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  module.note(48);
  module.note(255);
  CHECK(module.write_all(eeprom).empty());
}

TEST_CASE("every event there is can be written, up to the last code", "[H-13][H-20]") {
  for (const int code : {1, 9, 16, 26, 30, 31, 32, 33, 41}) {
    Eeprom eeprom = erased_eeprom();
    Started module(eeprom);
    module.note(static_cast<std::uint8_t>(code));
    CAPTURE(code);
    CHECK(module.write_all(eeprom).size() == 9);
    CHECK(int(eeprom[2048]) == code);
  }
}

TEST_CASE("a cut at any byte of a record costs the oldest at most, and the next start writes on", "[H-20]") {
  Eeprom full = erased_eeprom();
  for (unsigned i = 0; i < 300; ++i) {  // once round and a bit: the next record replaces an old one, at place 44
    live(full, i % 2 == 0 ? std::uint8_t{1} : std::uint8_t{6});
  }
  std::uint32_t seed = 1;
  for (const Eeprom& before : {erased_eeprom(), full}) {
    const bool is_full = before[2048] != 0xFF;
    const unsigned place = is_full ? 44 : 0;
    Started writer(before);
    writer.note(17, 0x5A);
    Eeprom done = before;
    const auto writes = writer.write_all(done);
    REQUIRE(writes.size() == 9);
    Eeprom reached = before;
    for (const spm::ByteWrite& write : writes) {
      for (const std::uint8_t outcome : torn(reached[write.address], write.value, seed)) {
        Eeprom cut = reached;
        cut[write.address] = outcome;
        // What stands at the place is the old record, the new one, or none.
        const auto found = spm::read_record(place_in(cut, place), static_cast<std::uint8_t>(place));
        const auto old = spm::read_record(place_in(before, place), static_cast<std::uint8_t>(place));
        const auto fresh = spm::read_record(place_in(done, place), static_cast<std::uint8_t>(place));
        const bool is_old = found && old && found->sequence == old->sequence && found->code == old->code;
        const bool is_new = found && found->sequence == fresh->sequence && found->code == 17 && found->argument == 0x5A;
        REQUIRE((!found || is_old || is_new));
        // The next start finds the newest and goes on, whole; nothing else has changed.
        Started next(cut);
        REQUIRE(int(next.storage.log().next_place()) == int(place + (is_new ? 1 : 0)));
        REQUIRE(next.storage.log().starts() == (is_full ? 301 : 1) + (is_new ? 1 : 0));
        next.note(1, 0);
        const auto at = next.storage.log().next_place();
        Eeprom after = cut;
        next.write_all(after);
        const auto record = spm::read_record(place_in(after, at), at);
        REQUIRE(record.has_value());
        REQUIRE(record->code == 1);
        for (unsigned i = 0; i < 256; ++i) {
          if (i != place && i != at) {
            REQUIRE(bytes_at(after, 2048 + 8 * i, 8) == bytes_at(before, 2048 + 8 * i, 8));
          }
        }
      }
      reached[write.address] = write.value;
    }
  }
}

}  // namespace
