// Packets as the models say and hear them (SB-2.3 to SB-2.12). Coded here by themselves, on purpose: models that
// shared the firmware's codec would share its mistakes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/time.hpp"

namespace simulation {

// From the start edge to Reception::at, in bit times of the receiver.
constexpr double bits_until_sampled = 9.625;

constexpr std::uint8_t end_of_turn = 0x0F;  // TF
// Without TF: 3 ms of silence end a packet, and a turn.
constexpr Time longest_silence = 3ms;

// Start byte, data with marker bits, checksum. Of every value the low seven bits count.
std::vector<std::uint8_t> seal(int type, const std::vector<int>& data);

// Puts together what a module hears. A packet with a wrong checksum, broken off, spoiled, or a run of stray bytes is
// bad, once.
class PacketReader {
 public:
  enum class Heard { nothing_yet, packet, end_of_turn };

  // `bit` is the listener's bit time.
  Heard hear(const Reception& reception, Time bit);
  // Nothing more belongs to what has been heard so far.
  void break_off();
  // The latest packet is no use to its listener: it counts as bad.
  void reject() { ++bad_; }

  // The latest packet, marker bits stripped.
  int type() const { return type_; }
  const std::vector<std::uint8_t>& data() const { return data_; }
  std::uint32_t bad() const { return bad_; }

 private:
  Heard close();

  std::vector<std::uint8_t> bytes_;  // being received; empty outside a packet
  Time last_{};
  int type_ = 0;
  std::vector<std::uint8_t> data_;
  std::uint32_t bad_ = 0;
};

}  // namespace simulation
