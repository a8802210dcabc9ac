// The supply: power button, sleep, the power-down handshake, and what to do when the remote is gone (section 4).
#pragma once

#include <stdint.h>

#include "bus/shark/packets.hpp"
#include "drivers/base/grant.hpp"
#include "drivers/base/time.hpp"
#include "spm/outputs.hpp"

namespace spm {

class Power {
 public:
  // Once, at the first step: all times count from here.
  void start(base::Instant now) { last_heard_ = last_active_ = now; }
  // A valid packet that proves the remote is there (SB-4.4).
  void heard(base::Instant now) { last_heard_ = now; }
  // One SR general. `is_active`: the driver did something; `sleep_after` = 0 never sleeps (SB-4.2).
  void general(const bus::shark::SrGeneral& packet, bool is_active, base::Millis sleep_after, base::Instant now);
  // Once in ten milliseconds. `is_safe`: no demand, brakes engaged (SB-4.5); `is_storing`: the EEPROM is being written,
  // or about to be (SB-4.3).
  void step(bool is_safe, bool is_storing, base::Instant now);

  Latch latch() const { return is_off_ ? Latch::release : Latch::hold; }
  bool is_off() const { return is_off_; }
  // At rest and about to let go: the last moment to have something written.
  bool is_leaving() const { return is_leaving_; }
  // From the accepted press on, nothing drives any more (SB-4.1).
  bool forbids_driving() const { return button_ == Button::accepted || is_down_asked_ || is_ending_; }
  bool is_down_asked() const { return is_down_asked_; }    // "power down now"
  bool is_sleep_asked() const { return is_sleep_asked_; }  // "sleep mode requested"
  // Bus idle mode: power-down or sleep was confirmed (SB-2.15).
  bool is_bus_idle() const { return confirmed_.is_given(); }
  bool is_intact() const { return confirmed_.is_intact(); }
  bool is_remote_gone() const { return is_ending_ && !is_bus_idle(); }

 private:
  enum class Button : uint8_t {
    not_seen_up,  // down since power-up: the press that woke us (SB-4.1)
    up,
    down,      // not yet long enough
    accepted,  // long enough: power down once it is released
  };

  void button(bool is_down, base::Instant now);
  void confirm(bool is_set);

  base::Instant last_heard_;  // or the start, if there was none yet
  base::Instant last_active_;
  base::Instant pressed_;
  base::Instant left_;  // when it was at rest and could have let go
  Button button_ = Button::not_seen_up;
  uint8_t confirms_ = 0;
  bool is_down_asked_ = false;
  bool is_sleep_asked_ = false;
  base::Grant confirmed_;  // H-27: it ends the watch for silence
  bool is_ending_ = false;
  bool is_leaving_ = false;
  bool is_off_ = false;
};

}  // namespace spm
