// The host's twin of the chip: what the drivers of one simulated machine have been told and will report.
// Every driver header is implemented in drivers/host over the machine that is selected, so several machines
// can live in one process: select one, run its firmware for a moment, select the next.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <utility>

#include "drivers/analog.hpp"
#include "drivers/base/heard_byte.hpp"
#include "drivers/base/ring.hpp"
#include "drivers/base/scan_order.hpp"
#include "drivers/base/time.hpp"
#include "drivers/base/turn_sender.hpp"
#include "drivers/base/wake_count.hpp"
#include "drivers/bridge.hpp"
#include "drivers/retained.hpp"
#include "drivers/self_test.hpp"
#include "drivers/signals.hpp"
#include "drivers/store.hpp"
#include "drivers/watchdog.hpp"

namespace drivers {
namespace host {

struct Machine {
  // Set by the simulation before the firmware runs.
  base::Instant now;
  base::Stamp stamp;
  bool wake = false;
  signals::Sensed sensed;
  std::array<std::uint16_t, analog::channel_count> analog_raw{};  // 0 to 1023
  watchdog::ResetCause reset_cause = watchdog::ResetCause::power_on;
  std::set<std::pair<std::uint32_t, int>> wrong_flash;  // bits: address and number
  bool is_ram_sound = true;
  bool is_stack_intact = true;

  // Filled by hear(), emptied by the firmware.
  base::Ring<base::HeardByte, 64> heard;
  base::WakeCount wake_count;
  bool is_loop_called = false;    // a character it waits for has come
  bool is_ticking_twice = false;  // the loop turns twice in a millisecond
  // What a simulated transmitter takes its bytes from, once state() is `speaking`.
  base::TurnSender sender;

  // Left behind by the firmware.
  bridge::Motion motion;
  signals::Switched switched;
  bool latch_held = false;
  std::uint32_t watchdog_feeds = 0;
  std::array<std::uint8_t, store::size> eeprom;  // erased (0xFF) when new
  bool is_store_writing = false;
  base::Instant store_written_at;

  // Of the converter.
  base::ScanOrder<analog::quick_channels, analog::channel_count> scan_order;
  std::uint16_t converting = 0;
  std::array<std::uint16_t, analog::channel_count> converted{};

  retained::Bytes retained{};
  // Of the self-test: what the program has found, and how far its round has come.
  self_test::Result self_test = self_test::Result::passed;
  std::uint32_t next_checked = 0;
  bool is_round_wrong = false;

  Machine() { eeprom.fill(0xFF); }

  // A character arrives at the receiver, at this machine's `stamp`. What is our own echo stays here.
  // False for such.
  bool hear(std::uint8_t value, bool is_spoiled);

 private:
  bool lost_one_ = false;
};

// The machine all drivers of this thread act on from now on; it must outlive its use.
void select(Machine& machine);
Machine& selected();

}  // namespace host
}  // namespace drivers
