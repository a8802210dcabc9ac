// What we say in one turn: our packets in order, closed by TF (SB-2.7).
//
//   SR:   general, others, TF
//   SPM:                      general | power-up, settings, TF        <- a Turn
//   SACU:                                                     ...
#pragma once

#include <stdint.h>

#include "bus/shark/codec.hpp"
#include "bus/shark/frame.hpp"
#include "drivers/base/span.hpp"

namespace bus {
namespace shark {

class Turn {
 public:
  // General 9 bytes, HHP data 10 or settings 4 (never both, SB-2.2), TF.
  static constexpr uint8_t capacity = 20;

  constexpr Turn() : bytes_(), size_(0) {}

  void open() { size_ = 0; }

  // Appends a whole packet, always leaving room for TF; false (and nothing added) when it does not fit.
  bool add(const Packet& packet) {
    const base::Span<const uint8_t> bytes = packet.bytes();
    if (size_ + bytes.size() >= capacity) {
      return false;
    }
    uint8_t* to = bytes_.items + size_;
    for (const uint8_t byte : bytes) {
      *to++ = byte;
    }
    size_ = static_cast<uint8_t>(size_ + bytes.size());
    return true;
  }

  void close() { bytes_[size_++] = transmit_finished; }

  base::Span<const uint8_t> bytes() const { return base::Span<const uint8_t>(bytes_.items, size_); }

 private:
  base::Array<uint8_t, capacity> bytes_;
  uint8_t size_;
};

}  // namespace shark
}  // namespace bus
