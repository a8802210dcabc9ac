// Measures every stop of the chair: from what somebody did, over the motors' first slowing, to standstill
// and brakes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/report/facts.hpp"

namespace simulation::report {

struct Stop {
  std::string cause;
  Time at{};                         // of the cause
  double speed = 0;                  // m/s, then
  Time slowing_after{};              // first fall of a motor's duty
  Time still_after{};                // chair at rest
  double distance = 0;               // m, from cause to rest
  std::optional<Time> braked_after;  // park brakes engaged
};

class Stops : public Observer {
 public:
  explicit Stops(const Facts& facts) : facts_(facts) {}

  // Something was done that may make the chair stop. Counts only while it moves.
  void on_cause(const std::string& cause, Time at);
  void on_sample(const Sample& sample) override;

  const std::vector<Stop>& all() const { return all_; }

 private:
  enum class Phase { none, waiting, slowing, still };

  void begin_phase(Phase phase, const Sample& sample);

  const Facts& facts_;
  std::vector<Stop> all_;
  Phase phase_ = Phase::none;
  Stop current_;
  double from_ = 0;  // position at the cause
  double duty_ = 0;  // largest since the cause
};

}  // namespace simulation::report
