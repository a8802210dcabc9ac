// One requester's operating mode handshake (SB-00.7): the request is echoed in the same turn, refused with a flag
// or established by its absence.
#pragma once

#include <stdint.h>

#include "bus/shark/packets.hpp"

namespace spm {

class OperatingMode {
 public:
  // A general's request. `is_allowed`: this mode may be entered now; drive mode always may.
  void request(uint8_t mode, bool is_allowed) {
    is_new_ = mode != mode_;
    const bool was_established = !is_new_ && !is_invalid_;
    mode_ = mode;
    // Never "invalid" with drive mode, nor once established, until the request changes.
    is_invalid_ = mode != bus::shark::mode::drive && !is_allowed && !was_established;
  }

  uint8_t mode() const { return mode_; }
  bool is_invalid() const { return is_invalid_; }
  bool is_drive() const { return mode_ == bus::shark::mode::drive; }
  // The last request differed from the one before it.
  bool has_changed() const { return is_new_; }

 private:
  uint8_t mode_ = bus::shark::mode::drive;
  bool is_invalid_ = false;
  bool is_new_ = false;
};

}  // namespace spm
