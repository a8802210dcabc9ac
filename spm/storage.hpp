// Everything that outlives the supply: the settings in two copies, and the event log.
//
//   0      settings, first copy
//   128    settings, second copy
//   2048   event log, to the end
//
// Values only. Board::store() is what reads and writes the EEPROM for it: once a millisecond, one byte at most, and
// only when the EEPROM has taken the one before. Nothing here waits.
#pragma once

#include <stdint.h>

#include "drivers/base/span.hpp"
#include "faults/event.hpp"
#include "spm/event_log.hpp"
#include "spm/settings_block.hpp"

namespace spm {

class Storage {
 public:
  constexpr Storage() : block_() {}

  // Once, before anything else: what both copies hold. If only one of them is sound, the other is written anew from it.
  LoadedSettings load(const SettingsBlock& first, const SettingsBlock& second);

  // Asks that `settings` be stored, which takes 55 bytes, 220 ms. False, and nothing done, while others are being
  // written; a copy that is written anew from the other gives way. Not to be asked on the way to power-down: the supply
  // would go before the end, and the old ones stay.
  bool store(const Settings& settings);
  bool is_storing() const { return written_ != is_idle; }

  void note(base::Span<const faults::Event> events);

  // Once a millisecond; those that the loop has missed do not count.
  void step() {
    if (--until_second_ == 0) {
      until_second_ = second;
      log_.second_passed();
    }
  }

  EventLog& log() { return log_; }
  const EventLog& log() const { return log_; }
  // Something is to be written, or being written.
  bool is_pending() const { return is_storing() || log_.is_pending(); }
  // Nothing to look at, nothing to write, and the EEPROM has taken the last byte.
  bool is_at_rest() const { return is_at_rest_; }
  // The next byte; call it when the EEPROM has taken the one before.
  base::Optional<ByteWrite> next_write();

 private:
  void begin(const Settings& settings);

  static constexpr uint8_t is_idle = 0xFF;
  static constexpr uint16_t second = 1000;  // milliseconds

  uint8_t next_copy_ = 0;      // the one that is not in use
  uint8_t sequence_ = 0;       // of the one in use
  SettingsBlock block_;        // what is being stored
  uint8_t written_ = is_idle;  // bytes of block_ that were handed out
  bool is_repairing_ = false;  // block_ is what the other copy holds
  EventLog log_;
  uint16_t until_second_ = second;
  bool is_at_rest_ = false;
};

}  // namespace spm
