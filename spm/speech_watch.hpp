// A transmitter that does not come to an end is switched off (H-30).
//
// Goals: it is on for 10 ms at most, and off within 25 whatever has become of it.
// Assumptions: asked with every millisecond's work; between two of our turns it is seen at rest.
// Invariants: none of our turns lasts so long (spm/limits.hpp).
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"
#include "spm/inputs.hpp"
#include "spm/limits.hpp"

namespace spm {

class SpeechWatch {
 public:
  // True if it must be switched off, now.
  bool is_hung(Speaker speaker, base::Instant now) {
    if (speaker != Speaker::speaking) {
      is_speaking_ = false;
      return false;
    }
    if (!is_speaking_) {
      is_speaking_ = true;
      since_ = static_cast<uint8_t>(now.count());
    }
    if (static_cast<uint8_t>(static_cast<uint8_t>(now.count()) - since_) < limits::longest_speech.count()) {
      return false;
    }
    is_speaking_ = false;
    return true;
  }

 private:
  bool is_speaking_ = false;
  uint8_t since_ = 0;  // when that was first seen, in milliseconds modulo 256
};

}  // namespace spm
