#include "bus/shark/framer.hpp"

namespace bus {
namespace shark {

using namespace base;  // literals

constexpr Micros Framer::longest_gap;

Verdict Framer::feed(const HeardByte& byte) {
  Verdict verdict;
  if (take_data(byte)) {
    return verdict;
  }
  end_overdue(byte.at, verdict);
  last_ = byte.at;
  is_line_quiet_ = false;

  if (byte.is_spoiled) {  // SB-2.10: nothing in it can be trusted, not even its marker
    drop_packet(verdict);
  } else if (has_marker(byte.value)) {
    if (state_ == State::packet) {  // all data has come: the checksum
      finish_packet(byte.value, verdict);
    } else {
      drop_packet(verdict);  // SB-2.10: a run of such bytes outside any packet is one corrupt packet
    }
  } else {
    if (state_ == State::packet) {  // SB-2.10: a new start byte before the packet is complete
      ++verdict.corrupt;
    }
    begin(byte.value);
    if (state_ == State::idle) {
      verdict.what = Verdict::What::finished;
    }
  }
  return verdict;
}

Verdict Framer::poll(Stamp now) {
  Verdict verdict;
  end_overdue(now, verdict);
  return verdict;
}

void Framer::reset() {
  state_ = State::idle;
  is_line_quiet_ = true;
}

// SB-2.10, SB-2.11: 3 ms without a byte end whatever was going on.
void Framer::end_overdue(Stamp now, Verdict& verdict) {
  if (!is_overdue(now)) {
    return;
  }
  if (state_ == State::packet) {
    ++verdict.corrupt;
  }
  state_ = State::idle;
  is_line_quiet_ = true;
  verdict.silence = true;
}

// A byte without a marker: TF, or the start of a packet.
void Framer::begin(uint8_t start) {
  if (start == transmit_finished) {  // SB-2.6
    state_ = State::idle;
    return;
  }
  frame_.type = type_of(start);
  frame_.length = length_of(start);
  received_ = 0;
  sum_ = start;
  state_ = State::packet;
}

void Framer::finish_packet(uint8_t byte, Verdict& verdict) {
  state_ = State::idle;
  if (byte == checksum(sum_)) {  // SB-2.5
    verdict.what = Verdict::What::frame;
  } else {  // SB-2.10
    ++verdict.corrupt;
  }
}

// The byte belongs to no sound packet, and nobody sends it again (SB-2.9); a collision looks no different (SB-2.18).
// Whatever follows up to a start byte, TF or silence goes with it.
void Framer::drop_packet(Verdict& verdict) {
  if (state_ != State::discard) {
    ++verdict.corrupt;
  }
  state_ = State::discard;
}

}  // namespace shark
}  // namespace bus
