// What a scenario does to the world, step by step, and the characters it keeps sending in the background.
#pragma once

#include <optional>
#include <string>

#include "simulation/scenario/step.hpp"
#include "simulation/world.hpp"

namespace simulation::scenario {

class Hands {
 public:
  explicit Hands(World& world) : world_(world) {}

  // Each returns what was done, in words for the story; empty: not worth a line.
  std::string press_power(bool down);
  std::string apply(const SetControls& controls);
  std::string apply(const SetRemote& remote);
  std::string apply(const SetSacu& sacu);
  std::string apply(const UseProgrammer& use);
  std::string apply(const CutCable&);
  std::string apply(const MendCable&);
  std::string apply(const Disturb& disturb);
  std::string apply(const Babble& babble);
  std::string apply(const Jam& jam);
  std::string apply(const WakePulse& pulse);
  std::string apply(const Break& broken);
  std::string apply(const BreakLamp& broken);
  std::string apply(const BreakActuator& broken);
  std::string apply(const SpoilMemory& spoiled);
  std::string apply(const Slope& slope);
  std::string apply(const Dci& dci);
  std::string apply(const Battery& battery);
  std::string apply(const Reset& reset);

  // Takes over from what is being sent at its next beat, or begins now.
  void begin_sending(const Send& send);
  void stop_sending() { sending_.reset(); }
  // When the next characters are due; nothing while none are.
  std::optional<Time> next_due() const;
  void send_if_due();

 private:
  struct Sending {
    Send what;
    Time due{};
    int left = 0;  // of `times`
  };

  World& world_;
  std::optional<Sending> sending_;
};

}  // namespace simulation::scenario
