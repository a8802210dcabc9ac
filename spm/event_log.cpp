#include "spm/event_log.hpp"

#include "drivers/base/flash.hpp"
#include "spm/events.hpp"

namespace spm {

namespace {

constexpr uint8_t no_record = 0xFF;  // instead of a code
constexpr uint8_t last_byte = RecordBytes::size() - 1;

// CRC-8: polynomial 0x07, first value 0; "123456789" gives 0xF4. The remainders of four bits at once.
const uint8_t remainders[16] IN_FLASH = {0x00, 0x07, 0x0E, 0x09, 0x1C, 0x1B, 0x12, 0x15,
                                         0x38, 0x3F, 0x36, 0x31, 0x24, 0x23, 0x2A, 0x2D};

uint8_t four_bits_on(uint8_t crc) {
  return static_cast<uint8_t>((crc << 4) ^ base::flash_byte(&remainders[crc >> 4]));
}

uint8_t crc8_of(const RecordBytes& bytes) {
  uint8_t crc = 0;
  for (uint8_t i = 0; i < last_byte; ++i) {
    crc = four_bits_on(four_bits_on(static_cast<uint8_t>(crc ^ bytes[i])));
  }
  return crc;
}

#define SPM_EVENT(name, number, words, argument, reason) \
  static_assert((number) < EventLog::codes, "the log would not write " #name);
#include "spm/events_list.inc"
#undef SPM_EVENT

uint16_t word_of(uint8_t low, uint8_t high) {
  return static_cast<uint16_t>(low | (static_cast<uint16_t>(high) << 8));
}

}  // namespace

base::Optional<LogRecord> read_record(const RecordBytes& bytes, uint8_t place) {
  if (bytes[0] == no_record || bytes[0] == 0 || bytes[last_byte] != crc8_of(bytes)) {
    return {};
  }
  LogRecord record;
  record.code = bytes[0];
  record.argument = bytes[1];
  record.sequence = word_of(place, bytes[2]);
  record.seconds = word_of(bytes[3], bytes[4]);
  record.starts = word_of(bytes[5], bytes[6]);
  return record;
}

RecordBytes make_record(const LogRecord& record) {
  RecordBytes bytes{};
  bytes[0] = record.code;
  bytes[1] = record.argument;
  bytes[2] = static_cast<uint8_t>(record.sequence >> 8);
  bytes[3] = static_cast<uint8_t>(record.seconds & 0xFF);
  bytes[4] = static_cast<uint8_t>(record.seconds >> 8);
  bytes[5] = static_cast<uint8_t>(record.starts & 0xFF);
  bytes[6] = static_cast<uint8_t>(record.starts >> 8);
  bytes[last_byte] = crc8_of(bytes);
  return bytes;
}

void EventLog::look(const RecordBytes& bytes) {
  const base::Optional<LogRecord> record = read_record(bytes, place_to_look_at());
  ++looked_at_;
  if (!record) {
    return;
  }
  const uint16_t after = static_cast<uint16_t>(record->sequence + 1U);
  if (!has_found_ || static_cast<uint16_t>(after - sequence_) < 0x8000U) {
    has_found_ = true;
    sequence_ = after;
    starts_ = static_cast<uint16_t>(record->starts + 1U);
  }
}

void EventLog::add(uint8_t code, uint8_t argument) {
  if (code >= codes || rest_[code] != 0) {
    return;
  }
  Wanted wanted;
  wanted.code = code;
  wanted.argument = argument;
  wanted.seconds = seconds_;
  if (wanted_.put(wanted)) {
    rest_[code] = rest_seconds + 1;  // the first of them may be nearly over
  }
}

void EventLog::second_passed() {
  if (seconds_ != UINT16_MAX) {
    ++seconds_;
  }
  for (uint8_t& rest : rest_) {
    if (rest != 0) {
      --rest;
    }
  }
}

base::Optional<ByteWrite> EventLog::next_write() {
  if (is_looking()) {
    return {};
  }
  if (written_ == is_idle) {
    Wanted wanted;
    if (!wanted_.take(wanted)) {
      return {};
    }
    LogRecord record;
    record.sequence = sequence_;
    record.code = wanted.code;
    record.argument = wanted.argument;
    record.seconds = wanted.seconds;
    record.starts = starts_;
    record_ = make_record(record);
    written_ = 0;
  }
  ByteWrite write;
  write.address = address_of_record(next_place());
  write.value = no_record;
  if (written_ > last_byte) {  // all others are written
    write.value = record_[0];
    written_ = is_idle;
    ++sequence_;
  } else {
    write.address = static_cast<uint16_t>(write.address + written_);
    if (written_ != 0) {
      write.value = record_[written_];
    }
    ++written_;
  }
  return write;
}

}  // namespace spm
