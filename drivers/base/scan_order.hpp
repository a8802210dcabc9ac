// Which analog channel is converted when: the quick ones, then one of the others, and over again.
#pragma once

#include <stdint.h>

namespace base {

template <uint8_t quick, uint8_t count>
class ScanOrder {
 public:
  uint8_t current() const { return current_; }
  // Every channel has had its turn.
  bool is_complete() const { return is_complete_; }

  void advance() {
    if (current_ >= quick) {
      is_complete_ = is_complete_ || current_ == count - 1;
      others_ = current_ < count - 1 ? static_cast<uint8_t>(current_ + 1) : quick;
    }
    current_ = current_ < quick - 1 ? static_cast<uint8_t>(current_ + 1) : current_ == quick - 1 ? others_ : uint8_t{0};
  }

 private:
  uint8_t current_ = 0;
  uint8_t others_ = quick;  // whose turn it is of those that come round slowly
  bool is_complete_ = false;
};

}  // namespace base
