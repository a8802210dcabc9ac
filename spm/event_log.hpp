// Events that outlive the supply: a ring of 256 records in the EEPROM, 8 bytes each.
//
//   0      1          2             3, 4                             5, 6                  7
//   code   argument   lap of ring   seconds since start, low first   starts, low first     CRC-8 of 0 to 6
//
// Lap and place in the ring together are the record's sequence number, 16 bits. 65535 seconds are "that or more".
// `starts` counts the starts that came as far as writing to the log; the record says to which of them it belongs.
//
// A code of 0xFF is no record: the place is erased or being written. A record is written one byte after the other: the
// old code away, everything else, the code last. So a cut at any bit of any byte leaves at most one place that is no
// record, that of the oldest: while anything else changes there is no record, and a torn code alone is an error within
// eight bits, which the CRC always finds (H-20).
//
// Writing one record takes 9 bytes, 36 ms. After a start the ring is looked through, two records in a millisecond, for
// its newest; events wait until then, 128 ms.
//
// How long it lasts: a cell stands 100,000 writes, and a record writes its first byte twice, so the ring stands 50,000
// laps. `pilotfish powercut` says how many years that is in use; a fault that chatters without a pause is written once
// a minute, which is 24 years.
//
// Values only: whoever steps it reads and writes the EEPROM.
#pragma once

#include <stdint.h>

#include "drivers/base/queue.hpp"
#include "drivers/base/span.hpp"

namespace spm {

// One byte for the EEPROM.
struct ByteWrite {
  uint16_t address = 0;
  uint8_t value = 0;
};

using RecordBytes = base::Array<uint8_t, 8>;

struct LogRecord {
  uint16_t sequence = 0;
  uint8_t code = 0;
  uint8_t argument = 0;
  uint16_t seconds = 0;
  uint16_t starts = 0;
};

constexpr uint16_t log_address = 2048;  // to the end of the EEPROM
constexpr uint16_t log_places = 256;

constexpr uint16_t address_of_record(uint8_t place) {
  return static_cast<uint16_t>(log_address + place * uint16_t{RecordBytes::size()});
}

// Nothing if there is no record in these bytes.
base::Optional<LogRecord> read_record(const RecordBytes& bytes, uint8_t place);
RecordBytes make_record(const LogRecord& record);

class EventLog {
 public:
  static constexpr uint8_t codes = 48;         // codes from 0 to 47 are written, others not
  static constexpr uint8_t rest_seconds = 60;  // of a code that was written

  constexpr EventLog() : wanted_(), record_(), rest_() {}

  // ---- after a start: give it all records, in order, until it has found the newest
  bool is_looking() const { return looked_at_ < log_places; }
  uint8_t place_to_look_at() const { return static_cast<uint8_t>(looked_at_); }
  void look(const RecordBytes& bytes);

  // ---- always
  // An event that happened now. The same code within 60 s is not written again; nor is one for which there is no room.
  void add(uint8_t code, uint8_t argument);
  void second_passed();

  // Something is to be written, or being written.
  bool is_pending() const { return !wanted_.empty() || written_ != is_idle; }
  // The next byte; call it when the EEPROM has taken the one before. Nothing while it is looking or has nothing to say.
  base::Optional<ByteWrite> next_write();

  // The number of this start; right once it has stopped looking.
  uint16_t starts() const { return starts_; }
  // Where the next record goes; the newest is the one before.
  uint8_t next_place() const { return static_cast<uint8_t>(sequence_ & 0xFF); }

 private:
  static constexpr uint8_t is_idle = 0xFF;

  struct Wanted {
    uint8_t code = 0;
    uint8_t argument = 0;
    uint16_t seconds = 0;
  };

  uint16_t looked_at_ = 0;
  bool has_found_ = false;
  uint16_t sequence_ = 0;  // of the next record
  uint16_t starts_ = 1;
  uint16_t seconds_ = 0;

  base::Queue<Wanted, 4> wanted_;
  RecordBytes record_;
  uint8_t written_ = is_idle;         // bytes of record_ that were handed out
  base::Array<uint8_t, codes> rest_;  // seconds until the code may be written again
};

}  // namespace spm
