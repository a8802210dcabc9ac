// Watches a power module from outside, in every run, and notes whatever breaks one of its clauses.
#pragma once

#include <string>
#include <vector>

#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/scene.hpp"
#include "simulation/world.hpp"

namespace simulation::monitor {

struct Breach {
  const Clause* clause = nullptr;
  Time at{};
  std::string seen;  // the numbers of that moment
};

class Monitor final : public Observer {
 public:
  // Clauses in `except`, by id, are not asked.
  explicit Monitor(const std::vector<std::string>& except = {});

  void on_byte(const BusByte& byte) override;
  void on_wake(bool asserted, Time at) override { scene_.take_wake(asserted, at); }
  void on_power(bool powered, Time at) override { scene_.take_power(powered, at); }
  void on_sample(const Sample& sample) override;

  // The first of each clause, in order of time.
  const std::vector<Breach>& breaches() const { return breaches_; }

 private:
  using Watched = std::vector<const Clause*>;

  void judge(Moment moment, Time at);

  Scene scene_;
  std::vector<Watched> watched_;  // by moment
  std::vector<Breach> breaches_;
};

}  // namespace simulation::monitor
