// What a power module at the end of the wire can have heard: whole packets, TF, corrupt packets, silence. A third text
// beside the firmware's framer and the report's listener, from the document alone (SB-2.3 to SB-2.12, SB-5.3).
//
// Where characters collide nobody can say what a receiver makes of them. Such packets are doubtful, and so is all that
// follows without a pause: they may permit, but never accuse.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "simulation/bus_event.hpp"

namespace simulation::monitor {

struct Packet {
  enum class Kind : std::uint8_t { packet, finished, corrupt, silence };

  Kind kind = Kind::corrupt;
  Time end{};
  bool is_doubtful = false;
  std::uint8_t type = 0;
  std::uint8_t length = 0;             // of the data
  std::array<std::uint8_t, 8> data{};  // markers stripped
};

class Ear {
 public:
  using Deliver = std::function<void(const Packet&)>;
  explicit Ear(Deliver deliver) : deliver_(std::move(deliver)) {}

  // In order of time: somebody else's character, and the power module's own, which it does not listen to.
  void hear(const BusByte& byte);
  void hear_own(const BusByte& byte);
  void advance(Time now);
  void forget();

 private:
  enum class State : std::uint8_t { idle, packet, discard };

  void occupy(const BusByte& byte);
  void take(std::uint8_t value, bool is_spoiled, Time end);
  void begin(std::uint8_t start, Time end);
  void append(std::uint8_t value, Time end);
  void fall_silent(Time now);
  void deliver(Packet::Kind kind, Time end);

  Deliver deliver_;
  State state_ = State::idle;
  Packet packet_;
  std::uint8_t received_ = 0;
  std::uint8_t sum_ = 0;
  Time last_{};               // end of the last character heard
  Time busy_until_{};         // end of the last character on the line
  bool is_quiet_ = true;      // silence was told since
  bool is_in_doubt_ = false;  // since a collision
};

}  // namespace simulation::monitor
