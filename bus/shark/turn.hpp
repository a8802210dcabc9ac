// What we say in one turn: our packets in order, closed by TF (SB-2.7).
//
//   SR:   general, others, TF
//   SPM:                      general, HHP data, settings, TF       <- a Turn; or power-up, TF
//   SACU:                                                     ...
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "bus/shark/packet_table.hpp"
#include "drivers/base/span.hpp"

namespace bus {
namespace shark {

class Turn {
 public:
  // The longest: 9 + 10 + 4 + TF = 24 bytes (SB-2.2).
  static constexpr uint8_t capacity =
      bytes_said(Type::spm_general) + bytes_said(Type::spm_hhp_data) + bytes_said(Type::spm_settings) + 1;

  constexpr Turn() : bytes_(), size_(0) {}

  void open() { size_ = 0; }

  // Appends a packet as it goes over the wire, always leaving room for TF; false (and nothing added) when it does not
  // fit.
  bool add(const Frame& frame) {
    if (size_ + frame.length + 2 >= capacity) {
      return false;
    }
    uint8_t* to = bytes_.items + size_;
    uint8_t sum = start_byte(static_cast<Type>(frame.type), frame.length);
    *to++ = sum;
    const uint8_t* from = frame.data.items;
    for (uint8_t left = frame.length; left != 0; --left) {
      const uint8_t byte = static_cast<uint8_t>(*from++ | marker_bit);  // SB-2.4
      *to++ = byte;
      sum = static_cast<uint8_t>(sum + byte);
    }
    *to = checksum(sum);  // SB-2.5
    size_ = static_cast<uint8_t>(size_ + frame.length + 2);
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
