// What goes on while the bench measures: the driver's hands, and how much everybody has to say.
#pragma once

#include <cstdint>
#include <string>

#include "simulation/world.hpp"

namespace simulation::bench {

enum class Load {
  idle,   // the remote's generals and the answers to them
  heavy,  // the longest turns that the document allows everybody
};

class Traffic {
 public:
  Traffic(World& world, Load load) : world_(world), is_heavy_(load == Load::heavy) {}

  // Wakes the power module and lets everybody find each other; in heavy traffic then the document's third example.
  void start();
  // The next half second, everybody at his longest.
  void go_on();
  // Until nothing is under way any more.
  void drain();

  std::uint64_t typed() const { return expected_.size(); }
  // Of the programmer's characters, how many did not come back in their place.
  std::uint64_t unreturned() const;

 private:
  void drive();
  void type();

  World& world_;
  bool is_heavy_;
  std::uint64_t halves_ = 0;  // seconds so far
  std::string expected_;      // on the programmer's screen
};

}  // namespace simulation::bench
