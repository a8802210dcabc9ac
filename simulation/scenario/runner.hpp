// Plays a scenario over a world, in simulated time.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/report/facts.hpp"
#include "simulation/report/story.hpp"
#include "simulation/scenario/hands.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

struct Failure {
  Mark mark;
  std::string expected;
  std::string seen;
  Time at{};
};

class Runner {
 public:
  // All must outlive the runner; facts and story observe the world.
  Runner(const Scenario& scenario, World& world, report::Facts& facts, report::Story& story);

  // Asked every millisecond; true ends the run.
  void stop_when(std::function<bool()> is_enough) { is_enough_ = std::move(is_enough); }

  // To the end, to the first expectation that is not met, or to where somebody has seen enough.
  std::optional<Failure> run();

 private:
  struct Watch {  // a `never` in force
    Mark mark;
    std::vector<Condition> conditions;
    Anchor since;
  };
  friend struct StepPlayer;

  using Check = std::function<std::optional<Failure>()>;

  // Lets time pass; every millisecond it checks the watches and `check`. True: nothing failed.
  bool advance(Time span, const Check& check = {});
  void settle();
  std::optional<Failure> check_watches() const;
  bool hold_on(const Step& step, const Hold& hold);
  bool wait_for(const Step& step, const Expect& expect);
  bool send(const Send& send);

  const Scenario& scenario_;
  World& world_;
  report::Facts& facts_;
  report::Story& story_;
  Hands hands_;
  std::vector<Watch> watches_;
  std::optional<Failure> failure_;
  std::function<bool()> is_enough_;
};

}  // namespace simulation::scenario
