// Noise that hits chosen packets: finds the borders of packets in what each sender says, and changes characters.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/bus_event.hpp"
#include "simulation/wire_line.hpp"

namespace simulation {

// Of the next `count` packets of one type from one sender. Everybody hears it, the sender included.
struct Disturbance {
  enum class Way {
    corrupt_checksum,
    flip_bit,
    drop,
    framing_error,  // the byte's first stop bit is dominant
    late_byte,      // the byte comes later, and with it the rest of its sender's turn
  };
  Way way = Way::corrupt_checksum;
  Sender sender = Sender::sr;
  std::uint8_t type = 0;  // low nibble of the start byte; 0x0F is TF
  int byte = 0;           // in the packet, 0 = start byte
  int bit = 0;
  int count = 1;
  Time by{};  // how late
};

class WireFaults {
 public:
  void add(const Disturbance& disturbance) { waiting_.push_back(disturbance); }
  // For every character, in the order in which its sender says them.
  void pass(Character& character);

 private:
  struct Packet {
    int place = 0;  // of the latest character
    int size = 0;
    std::optional<Disturbance> fate;
  };
  struct Turn {
    Time planned{};  // start of the latest character, as its sender wants it
    Time late{};     // by how much it and the rest come later
  };

  void keep_late(Character& character);
  std::optional<Disturbance> take(const Character& start);

  std::vector<Disturbance> waiting_;
  std::array<Packet, sender_count> packets_;  // by sender
  std::array<Turn, sender_count> turns_;
};

}  // namespace simulation
