// A second framer, slow and obvious, written from the document's rules (SB-2.3 to SB-2.6, SB-2.10 to SB-2.12) and from
// nothing else, to judge the product's. It has no state and no clock: it looks at the whole recorded stream at once,
// cuts it at the silences, and reads each piece from its first byte to its last.
//
// Where the rules leave room, this is the reading:
// - a spoiled byte is neither start byte, data nor TF, whatever its value seems to be;
// - a packet with a spoiled byte in it reaches to the next start byte, TF or silence, because after an error (an
// overrun
//   above all) its bytes can no longer be counted;
// - a run of stray bytes is found corrupt at its first byte, a packet at the byte or the silence that shows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace reference {

// One character as recorded. Times are absolute, in microseconds.
struct Byte {
  std::uint8_t value = 0;
  bool is_spoiled = false;
  std::uint64_t at = 0;  // its receipt: the first stop bit
};

constexpr std::uint64_t from_receipt_to_end = 36;  // SB-2.1: the rest of two stop bits
constexpr std::uint64_t longest_silence = 3000;    // SB-2.11

struct Packet {
  int type = 0;
  std::vector<std::uint8_t> data;  // marker bits stripped
  bool operator==(const Packet&) const = default;
};

// What a byte has brought to light, the silence before it included.
struct Outcome {
  int corrupt = 0;  // packets found corrupt
  bool silence = false;
  bool finished = false;  // TF
  std::optional<Packet> packet;
  bool operator==(const Outcome&) const = default;
};

using Stream = std::vector<Byte>;

class Reading {
 public:
  // One outcome a byte, and one for the silence after the last.
  explicit Reading(const Stream& stream) : stream_(stream), outcomes_(stream.size() + 1) {
    std::size_t from = 0;
    for (std::size_t i = 1; i <= stream.size(); ++i) {
      if (i == stream.size() || stream[i].at - stream[i - 1].at >= from_receipt_to_end + longest_silence) {
        read_piece(from, i);
        outcomes_[i].silence = true;  // SB-2.12
        from = i;
      }
    }
  }

  const std::vector<Outcome>& outcomes() const { return outcomes_; }

 private:
  // Bytes `from` to before `until`, nowhere 3 ms apart.
  void read_piece(std::size_t from, std::size_t until) {
    while (from < until) {
      if (!is_unmarked(from)) {
        ++outcomes_[from].corrupt;  // SB-2.10: strays
        from = next_unmarked(from, until);
      } else if (stream_[from].value == 0x0F) {
        outcomes_[from].finished = true;  // SB-2.6
        ++from;
      } else {
        from = read_packet(from, until);
      }
    }
  }

  // From a start byte; to the first byte that belongs to something else.
  std::size_t read_packet(std::size_t from, std::size_t until) {
    const std::size_t length = static_cast<std::size_t>(stream_[from].value >> 4) + 1;  // SB-2.3
    const std::size_t checksum = from + length + 1;
    for (std::size_t i = from + 1; i <= checksum; ++i) {
      if (i == until || is_unmarked(i)) {
        ++outcomes_[i].corrupt;  // SB-2.10: cut short by silence or by a start byte
        return i;
      }
      if (stream_[i].is_spoiled) {
        ++outcomes_[i].corrupt;  // SB-2.10: framing or overrun error
        return next_unmarked(i, until);
      }
    }
    if (is_sum_right(from, checksum)) {
      outcomes_[checksum].packet = packet(from, length);
    } else {
      ++outcomes_[checksum].corrupt;
    }
    return checksum + 1;
  }

  // SB-2.4: only start bytes and TF have bit 7 clear.
  bool is_unmarked(std::size_t i) const { return !stream_[i].is_spoiled && stream_[i].value < 0x80; }

  std::size_t next_unmarked(std::size_t from, std::size_t until) const {
    while (from < until && !is_unmarked(from)) {
      ++from;
    }
    return from;
  }

  // SB-2.5
  bool is_sum_right(std::size_t from, std::size_t checksum) const {
    unsigned sum = 0;
    for (std::size_t i = from; i < checksum; ++i) {
      sum += stream_[i].value;
    }
    return stream_[checksum].value == 0x80 + (0x7F - sum % 0x80);
  }

  Packet packet(std::size_t from, std::size_t length) const {
    Packet packet{stream_[from].value % 16, {}};
    for (std::size_t i = from + 1; i <= from + length; ++i) {
      packet.data.push_back(static_cast<std::uint8_t>(stream_[i].value % 0x80));
    }
    return packet;
  }

  const Stream& stream_;
  std::vector<Outcome> outcomes_;
};

}  // namespace reference
