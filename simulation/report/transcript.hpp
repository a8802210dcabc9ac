// What was said on the bus, without the clock: bytes and senders, cut into the remote's cycles. Two machines
// that run the same firmware must say the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/world.hpp"

namespace simulation::report {

class Transcript : public Observer {
 public:
  // A cycle begins with the SR's first byte after a pause of its own; what comes before the first is cycle 0.
  struct Cycle {
    std::vector<BusByte> bytes;
  };

  Transcript() : cycles_(1) {}

  void on_byte(const BusByte& byte) override;

  const std::vector<Cycle>& cycles() const { return cycles_; }
  std::size_t byte_count() const;
  // FNV-1a, 64 bits, over the senders and bytes as sent, cycle by cycle.
  std::uint64_t hash() const;

 private:
  std::vector<Cycle> cycles_;
  std::optional<Time> sr_until_;
};

// The last `count` cycles, one line a packet.
std::string tell_last_cycles(const Transcript& transcript, std::size_t count);

// Where two transcripts part for the first time, in words with both sides decoded; nothing if they agree.
struct Side {
  std::string name;  // "avr", "host"
  const Transcript& transcript;
};
std::optional<std::string> first_difference(const Side& one, const Side& other);

}  // namespace simulation::report
