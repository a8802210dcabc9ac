#include "simulation/report/packet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace simulation::report {
namespace {

using namespace bus::shark;

constexpr Time longest_gap = 3ms;  // SB-2.10, SB-2.12
constexpr Time overlap = 30us;     // more than a stop bit's
constexpr const char* collision = "two speak at once";

bool has_right_checksum(const std::vector<std::uint8_t>& bytes) {
  const unsigned sum = std::accumulate(bytes.begin(), bytes.end() - 1, 0U);
  return bytes.back() == (0x80U | (0x7FU - (sum & 0x7FU)));  // SB-2.5
}

}  // namespace

bool Packet::is(Type wanted) const {
  return kind == Kind::packet && type() == static_cast<std::uint8_t>(wanted);
}

std::vector<std::uint8_t> Packet::data() const {
  std::vector<std::uint8_t> stripped(bytes.begin() + 1, bytes.end() - 1);
  for (std::uint8_t& byte : stripped) {
    byte &= 0x7F;
  }
  return stripped;
}

std::string name_of(Sender sender) {
  switch (sender) {
    case Sender::sr:
      return "SR";
    case Sender::spm:
      return "SPM";
    case Sender::sacu:
      return "SACU";
    case Sender::tester:
      return "tester";
    case Sender::noise:
      break;
  }
  return "noise";
}

std::string hex(const std::vector<std::uint8_t>& bytes) {
  return fmt::format("{:02X}", fmt::join(bytes, " "));
}

void Listener::hear(const BusByte& byte) {
  if (byte.lost) {
    return;
  }
  advance(byte.start);
  const bool collides = byte.sender != last_sender_ && byte.start + overlap < last_;
  last_ = std::max(last_, byte.end);
  last_sender_ = byte.sender;
  if (byte.spoiled || collides) {
    if (!is_open_) {
      begin(byte);
    } else {
      packet_.bytes.push_back(byte.heard);
    }
    packet_.end = byte.end;
    packet_.flaw = collides || packet_.flaw == collision ? collision : "framing error";
    is_stray_ = true;
    return;
  }
  if (has_marker(byte.heard)) {
    append(byte);
    return;
  }
  if (is_open_) {
    give_up(fmt::format("broken off after {} bytes", packet_.bytes.size()));
  }
  begin(byte);
  if (byte.heard == transmit_finished) {
    finish(Packet::Kind::finished);
  }
}

void Listener::advance(Time now) {
  if (is_open_ && now - last_ >= longest_gap) {
    const auto count = packet_.bytes.size();
    give_up(fmt::format("incomplete: {} {}, then silence", count, count == 1 ? "byte" : "bytes"));
  }
}

void Listener::begin(const BusByte& byte) {
  packet_ = Packet{};
  packet_.sender = byte.sender;
  packet_.start = byte.start;
  packet_.end = byte.end;
  packet_.bytes = {byte.heard};
  is_open_ = true;
  is_stray_ = false;
}

void Listener::append(const BusByte& byte) {
  if (!is_open_) {
    begin(byte);
    is_stray_ = true;
    packet_.flaw = "outside any packet";
    return;
  }
  packet_.bytes.push_back(byte.heard);
  packet_.end = byte.end;
  if (is_stray_ || packet_.bytes.size() < length_of(packet_.bytes.front()) + 2U) {
    return;
  }
  if (has_right_checksum(packet_.bytes)) {
    finish(Packet::Kind::packet);
  } else {
    give_up("wrong checksum");
  }
}

void Listener::give_up(const std::string& flaw) {
  if (packet_.flaw.empty()) {
    packet_.flaw = flaw;
  }
  finish(Packet::Kind::corrupt);
}

void Listener::finish(Packet::Kind kind) {
  packet_.kind = kind;
  is_open_ = false;
  is_stray_ = false;
  deliver_(packet_);
}

}  // namespace simulation::report
