// Bytes and their times become frames, turn ends and corrupt packets (SB-2.3 to SB-2.6, SB-2.10 to SB-2.12).
//
// Goals: whatever comes in, the next whole packet after it is understood; one verdict a packet.
// Assumptions: bytes come oldest first, stamped at their first stop bit; poll() is called 3 to 3.4 ms after the last.
// Invariants: at most one packet is being assembled; a verdict is given once; no byte ever counts for two packets.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "drivers/base/heard_byte.hpp"
#include "drivers/base/time.hpp"

namespace bus {
namespace shark {

// What one byte, or the passing of time, has brought to light, in this order.
struct Verdict {
  enum class What : uint8_t {
    nothing,
    frame,     // a packet with the right checksum: see Framer::frame()
    finished,  // TF
  };
  uint8_t corrupt = 0;   // packets found corrupt: the one before this byte, and this byte itself as a stray
  bool silence = false;  // 3 ms passed without a byte: the turn is over (SB-2.11, SB-2.12)
  What what = What::nothing;

  bool is_empty() const { return corrupt == 0 && !silence && what == What::nothing; }
};

class Framer {
 public:
  Verdict feed(const base::HeardByte& byte);
  // The usual case of feed(), told apart because most bytes are it and it brings no verdict: the next data byte of the
  // packet, in time. False, and nothing done, for any other.
  bool take_data(const base::HeardByte& byte) {
    if (state_ != State::packet || received_ >= frame_.length || byte.is_spoiled || !has_marker(byte.value) ||
        byte.at - last_ >= longest_gap) {
      return false;
    }
    last_ = byte.at;
    frame_.data[received_] = static_cast<uint8_t>(byte.value & ~marker_bit);
    ++received_;
    sum_ = static_cast<uint8_t>(sum_ + byte.value);
    return true;
  }
  // Call when no byte is waiting. Only if is_overdue() there is a verdict.
  Verdict poll(base::Stamp now);
  bool is_overdue(base::Stamp now) const { return !is_line_quiet_ && now - last_ >= longest_gap; }

  // The frame of the last `frame` verdict; valid until the next feed().
  const Frame& frame() const { return frame_; }

  // True while a packet lacks two bytes at most: its verdict is that near, so long work waits.
  bool is_nearly_complete() const { return state_ == State::packet && received_ + 1 >= frame_.length; }

  // Characters until there will be a verdict, the one that brings it included; 0 if any next one may bring it.
  uint8_t missing() const {
    return state_ == State::packet ? static_cast<uint8_t>(frame_.length + 1 - received_) : uint8_t{0};
  }

  // A packet of this type is on its way.
  bool is_receiving(Type type) const { return state_ == State::packet && frame_.is(type); }

  // When the last byte came, as far as it is less than 65 ms ago.
  base::Stamp last_byte() const { return last_; }

  // Forgets a packet in progress without a verdict, as when wake makes the bus unreadable (SB-1.3).
  void reset();

 private:
  // SB-2.11: 3 ms from the end of the byte, 36 us after its stamp.
  static constexpr base::Micros longest_gap = base::Micros(3036);

  enum class State : uint8_t {
    idle,     // between packets
    packet,   // start byte seen
    discard,  // in a corrupt packet that has had its verdict: until a start byte, TF or silence
  };

  void end_overdue(base::Stamp now, Verdict& verdict);
  void begin(uint8_t start);
  void finish_packet(uint8_t byte, Verdict& verdict);
  void drop_packet(Verdict& verdict);

  Frame frame_;
  State state_ = State::idle;
  uint8_t received_ = 0;  // data bytes so far
  uint8_t sum_ = 0;
  base::Stamp last_;           // of the last byte
  bool is_line_quiet_ = true;  // silence has been reported since the last byte
};

}  // namespace shark
}  // namespace bus
