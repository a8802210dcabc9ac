// The only place where the power module meets its drivers: readings become Inputs, Outputs become pins.
#pragma once

#include "drivers/base/time.hpp"
#include "faults/heartbeat.hpp"
#include "spm/inputs.hpp"
#include "spm/outputs.hpp"
#include "spm/restart_watch.hpp"
#include "spm/settings.hpp"
#include "spm/storage.hpp"

namespace spm {

class Board {
 public:
  // All drivers, once after reset, interrupts off. Every output is safe afterwards.
  void start();
  // As stored; that they could not be read shows in every later sense().
  Settings load(Storage& storage);

  // What the bus says is always new; of voltages, currents and switches one is read each millisecond, in turn.
  const Inputs& sense(base::Instant now);
  void apply(const Outputs& outputs);
  // H-25: what was done since this was last asked.
  faults::Beats take_beats() {
    const faults::Beats done = beats_;
    beats_ = faults::Beats();
    return done;
  }
  // Once a millisecond: one byte for the EEPROM, if it is ready for it.
  void store(Storage& storage);

 private:
  void sense_bus();
  void sense_next();
  void look_at_chip();

  Inputs in_;
  faults::Beats beats_;
  RestartWatch restarts_;
  base::Instant last_slow_;
  bool is_new_millisecond_ = false;  // and motors and brakes were not yet written in it
  uint8_t turn_ = 0;                 // whose it is to be read
  uint8_t awaited_ = 0;              // as the transceiver was told
};

}  // namespace spm
