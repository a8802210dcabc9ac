#include "simulation/models/packets.hpp"

#include <cmath>

namespace simulation {
namespace {

constexpr std::uint8_t marker = 0x80;

std::size_t data_length(std::uint8_t start_byte) {
  return static_cast<std::size_t>(start_byte >> 4) + 1;
}

// SB-2.5: the low seven bits of everything, the checksum included, come to 0x7F.
bool adds_up(const std::vector<std::uint8_t>& packet) {
  int sum = 0;
  for (const std::uint8_t byte : packet) {
    sum += byte & 0x7F;
  }
  return (sum & 0x7F) == 0x7F;
}

}  // namespace

std::vector<std::uint8_t> seal(int type, const std::vector<int>& data) {
  const int start = static_cast<int>(data.size() - 1) << 4 | type;
  std::vector<std::uint8_t> packet{static_cast<std::uint8_t>(start)};
  int sum = start;
  for (const int value : data) {
    packet.push_back(static_cast<std::uint8_t>(marker | (value & 0x7F)));
    sum += value & 0x7F;
  }
  packet.push_back(static_cast<std::uint8_t>(marker | (0x7F - (sum & 0x7F))));  // SB-2.5
  return packet;
}

PacketReader::Heard PacketReader::hear(const Reception& reception, Time bit) {
  const Time from = reception.at - Time(std::llround(static_cast<double>(bit.count()) * bits_until_sampled));
  // A run of stray bytes is kept as a packet, too: it is bad once, when it ends.
  if (from - last_ > longest_silence) {
    break_off();
  }
  last_ = reception.at;
  const bool is_start = (reception.value & marker) == 0 && !reception.framing_error;
  if (is_start) {
    break_off();
  }
  if (is_start && reception.value == end_of_turn) {
    return Heard::end_of_turn;
  }
  // A spoiled byte turns what it stands in into strays.
  if (reception.framing_error) {
    bytes_.assign(1, marker);
    return Heard::nothing_yet;
  }
  bytes_.push_back(reception.value);
  const bool is_packet = (bytes_.front() & marker) == 0;
  return is_packet && bytes_.size() == data_length(bytes_.front()) + 2 ? close() : Heard::nothing_yet;
}

PacketReader::Heard PacketReader::close() {
  const bool is_good = adds_up(bytes_);
  if (is_good) {
    type_ = bytes_.front() & 0x0F;
    data_.assign(bytes_.begin() + 1, bytes_.end() - 1);
    for (std::uint8_t& byte : data_) {
      byte &= 0x7F;
    }
  } else {
    ++bad_;
  }
  bytes_.clear();
  return is_good ? Heard::packet : Heard::nothing_yet;
}

void PacketReader::break_off() {
  if (!bytes_.empty()) {
    bytes_.clear();
    ++bad_;
  }
}

}  // namespace simulation
