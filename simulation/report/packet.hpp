// What a passive listener with a perfect clock makes of the line: whole packets, turn ends, and what is left
// of broken ones (SB-2.3 to SB-2.12). Written apart from the firmware's framer, so that one checks the other.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bus/shark/frame.hpp"
#include "simulation/bus_event.hpp"

namespace simulation::report {

struct Packet {
  enum class Kind { packet, finished, corrupt };

  Kind kind = Kind::corrupt;
  Sender sender = Sender::noise;  // of its first byte
  Time start{};
  Time end{};
  std::vector<std::uint8_t> bytes;  // as heard, start byte and checksum included
  std::string flaw;                 // why it is corrupt, in words

  bool is(bus::shark::Type type) const;
  std::uint8_t type() const { return bus::shark::type_of(bytes.front()); }
  std::vector<std::uint8_t> data() const;  // marker bits stripped; of a whole packet only
};

std::string name_of(Sender sender);  // "SR", "SPM", ...
std::string hex(const std::vector<std::uint8_t>& bytes);

class Listener {
 public:
  using Deliver = std::function<void(const Packet&)>;
  explicit Listener(Deliver deliver) : deliver_(std::move(deliver)) {}

  // In order of time. Bytes that never reached the line are passed over.
  void hear(const BusByte& byte);
  // Lets 3 ms of silence take effect.
  void advance(Time now);

 private:
  void begin(const BusByte& byte);
  void append(const BusByte& byte);
  void give_up(const std::string& flaw);
  void finish(Packet::Kind kind);

  Deliver deliver_;
  Packet packet_;
  bool is_open_ = false;   // a packet is being put together
  bool is_stray_ = false;  // bytes outside any packet (SB-2.10)
  Time last_{};
  Sender last_sender_ = Sender::noise;
};

}  // namespace simulation::report
