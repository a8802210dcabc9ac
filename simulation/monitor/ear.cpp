#include "simulation/monitor/ear.hpp"

#include <algorithm>

namespace simulation::monitor {
namespace {

constexpr Time longest_gap = 3ms;        // SB-2.11
constexpr Time surely_silent = 3500us;   // SB-2.11
constexpr Time perhaps_silent = 2600us;  // a character that ends after 3 ms may come too late
constexpr Time overlap = 30us;           // more than a stop bit's
constexpr Time pause = 350us;            // more than a character: whoever listens is in step again

constexpr std::uint8_t marker = 0x80;
constexpr std::uint8_t transmit_finished = 0x0F;

// SB-5.3; 0 = unknown to a power module
constexpr std::array<std::uint8_t, 16> least_data = {6, 0, 1, 0, 6, 0, 1, 3, 6, 7, 0, 0, 0, 0, 0, 0};

}  // namespace

void Ear::hear(const BusByte& byte) {
  const Time gap = byte.start - last_;
  if (!is_quiet_ && gap >= longest_gap) {
    fall_silent(byte.start);
  }
  occupy(byte);
  packet_.is_doubtful = packet_.is_doubtful || is_in_doubt_ || (!is_quiet_ && gap >= perhaps_silent);
  is_quiet_ = false;
  last_ = byte.end;
  take(byte.heard, byte.spoiled, byte.end);
}

void Ear::hear_own(const BusByte& byte) {
  occupy(byte);
  packet_.is_doubtful = packet_.is_doubtful || is_in_doubt_;
}

void Ear::advance(Time now) {
  if (!is_quiet_ && now - last_ >= surely_silent) {
    fall_silent(now);
  }
}

void Ear::forget() {
  state_ = State::idle;
  is_quiet_ = true;
}

void Ear::occupy(const BusByte& byte) {
  if (byte.start + overlap < busy_until_) {
    is_in_doubt_ = true;
  } else if (byte.start - busy_until_ >= pause) {
    is_in_doubt_ = false;
  }
  busy_until_ = std::max(busy_until_, byte.end);
}

void Ear::take(std::uint8_t value, bool is_spoiled, Time end) {
  const bool has_marker = (value & marker) != 0;
  if (state_ == State::packet && has_marker && !is_spoiled) {
    append(value, end);
  } else if (is_spoiled || has_marker) {  // SB-2.10: what belongs to no packet is one corrupt packet
    if (state_ != State::discard) {
      deliver(Packet::Kind::corrupt, end);
    }
    state_ = State::discard;
  } else {
    if (state_ == State::packet) {
      deliver(Packet::Kind::corrupt, end);
    }
    begin(value, end);
  }
}

void Ear::begin(std::uint8_t start, Time end) {
  packet_ = Packet{};
  packet_.is_doubtful = is_in_doubt_;
  if (start == transmit_finished) {
    state_ = State::idle;
    deliver(Packet::Kind::finished, end);
    return;
  }
  packet_.type = start & 0x0F;
  packet_.length = static_cast<std::uint8_t>((start >> 4) + 1);
  received_ = 0;
  sum_ = start;
  state_ = State::packet;
}

void Ear::append(std::uint8_t value, Time end) {
  const std::uint8_t bits = value & 0x7F;
  if (received_ < packet_.length) {
    packet_.data[received_++] = bits;
    sum_ = static_cast<std::uint8_t>(sum_ + bits);
    return;
  }
  state_ = State::idle;
  const bool is_right = bits == 0x7F - (sum_ & 0x7F);  // SB-2.5
  const bool is_long_enough = packet_.length >= least_data[packet_.type];
  deliver(is_right && is_long_enough ? Packet::Kind::packet : Packet::Kind::corrupt, end);
}

void Ear::fall_silent(Time now) {
  if (state_ == State::packet) {
    deliver(Packet::Kind::corrupt, now);
  }
  state_ = State::idle;
  is_quiet_ = true;
  deliver(Packet::Kind::silence, now);
}

void Ear::deliver(Packet::Kind kind, Time end) {
  packet_.kind = kind;
  packet_.end = end;
  const Packet told = packet_;
  packet_ = Packet{};
  deliver_(told);
}

}  // namespace simulation::monitor
