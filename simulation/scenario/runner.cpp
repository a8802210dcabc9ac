#include "simulation/scenario/runner.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace simulation::scenario {
namespace {

constexpr Time tick = 1ms;  // conditions are looked at this often
constexpr Time middle_of_cycle = 12ms;
constexpr Time cycle = 20ms;
constexpr Time quiet = 4ms;  // a pause between turns
constexpr Time patience_for_quiet = 60ms;

bool are_all_true(const std::vector<Condition>& conditions, const report::Facts& facts, const Anchor& since) {
  return std::all_of(conditions.begin(), conditions.end(),
                     [&](const Condition& condition) { return condition.holds(facts, since); });
}

std::string join_texts(const std::vector<Condition>& conditions) {
  std::vector<std::string> texts;
  for (const Condition& condition : conditions) {
    texts.push_back(condition.text);
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

// Of those that are not as they should be; with `all`, of the rest too.
std::string tell_seen(const std::vector<Condition>& conditions, const report::Facts& facts, const Anchor& since,
                      bool all) {
  std::vector<std::string> texts;
  for (const Condition& condition : conditions) {
    if (all || !condition.holds(facts, since)) {
      const std::string word = condition.text.substr(0, condition.text.find(':'));
      texts.push_back(fmt::format("{}: {}", word, condition.seen(facts, since)));
    }
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

const Mark& mark_of_first_untrue(const std::vector<Condition>& conditions, const report::Facts& facts,
                                 const Anchor& since) {
  const auto untrue = std::find_if(conditions.begin(), conditions.end(),
                                   [&](const Condition& condition) { return !condition.holds(facts, since); });
  return (untrue == conditions.end() ? conditions.front() : *untrue).mark;
}

Time up_to_tick(Time at) {
  return (at / tick + 1) * tick;
}

}  // namespace

// Plays one step; true while nothing has failed.
struct StepPlayer {
  Runner& runner;
  const Step& step;

  bool operator()(const Say& say) const {
    runner.story_.say(say.text, runner.world_.now());
    return true;
  }
  bool operator()(const Note& note) const {
    runner.story_.note(note.text, runner.world_.now());
    return true;
  }
  bool operator()(const Wait& wait) const { return runner.advance(wait.span); }
  bool operator()(const WaitForMidCycle&) const {
    const auto begin = runner.facts_.sr_turn_began_at();
    if (!begin) {
      return runner.advance(middle_of_cycle);
    }
    Time target = *begin + middle_of_cycle;
    while (target <= runner.world_.now()) {
      target += cycle;
    }
    return runner.advance(target - runner.world_.now());
  }
  bool operator()(const PressPower& press) const {
    tell(runner.hands_.press_power(true));
    const bool went_well = runner.advance(press.span);
    tell(runner.hands_.press_power(false));
    return went_well;
  }
  bool operator()(const Expect& expect) const { return runner.wait_for(step, expect); }
  bool operator()(const Hold& hold) const { return runner.hold_on(step, hold); }
  bool operator()(const Never& never) const {
    runner.watches_.push_back({step.mark, never.conditions, runner.facts_.anchor()});
    return true;
  }
  bool operator()(const Send& send) const { return runner.send(send); }
  bool operator()(const StopSending&) const {
    runner.hands_.stop_sending();
    return true;
  }
  template <typename Deed>
  bool operator()(const Deed& deed) const {
    tell(runner.hands_.apply(deed));
    return true;
  }

  void tell(const std::string& deed) const {
    if (!deed.empty()) {
      runner.story_.tell_deed(deed, runner.world_.now());
    }
  }
};

Runner::Runner(const Scenario& scenario, World& world, report::Facts& facts, report::Story& story)
    : scenario_(scenario), world_(world), facts_(facts), story_(story), hands_(world) {}

std::optional<Failure> Runner::run() {
  for (const Step& step : scenario_.steps) {
    if (!std::visit(StepPlayer{*this, step}, step.action)) {
      return failure_;
    }
  }
  settle();
  return failure_;
}

bool Runner::advance(Time span, const Check& check) {
  const Time end = world_.now() + span;
  while (world_.now() < end) {
    Time next = std::min(end, up_to_tick(world_.now()));
    if (const auto due = hands_.next_due()) {
      next = std::clamp(*due, world_.now(), next);
    }
    world_.run_until(next);
    hands_.send_if_due();
    failure_ = check_watches();
    if (!failure_ && check) {
      failure_ = check();
    }
    if (failure_ || (is_enough_ && is_enough_())) {
      return false;
    }
  }
  return true;
}

// Ends between two turns, so that a transcript never breaks off in the middle of an answer.
void Runner::settle() {
  hands_.stop_sending();
  const Time limit = world_.now() + patience_for_quiet;
  while (world_.now() < limit && world_.now() - facts_.last_byte_ended_at() < quiet && advance(tick)) {
  }
}

std::optional<Failure> Runner::check_watches() const {
  for (const Watch& watch : watches_) {
    if (are_all_true(watch.conditions, facts_, watch.since)) {
      return Failure{watch.mark, fmt::format("never {}", join_texts(watch.conditions)),
                     tell_seen(watch.conditions, facts_, watch.since, true), world_.now()};
    }
  }
  return std::nullopt;
}

bool Runner::hold_on(const Step&, const Hold& hold) {
  const Anchor since = facts_.anchor();
  const auto check = [&]() -> std::optional<Failure> {
    if (are_all_true(hold.conditions, facts_, since)) {
      return std::nullopt;
    }
    return Failure{mark_of_first_untrue(hold.conditions, facts_, since),
                   fmt::format("{} for {}", join_texts(hold.conditions), show(seconds(hold.span), Measure::time)),
                   fmt::format("{} after {}", tell_seen(hold.conditions, facts_, since, false),
                               show(seconds(world_.now() - since.at), Measure::time)),
                   world_.now()};
  };
  failure_ = check();
  return !failure_ && advance(hold.span, check);
}

bool Runner::wait_for(const Step&, const Expect& expect) {
  const Anchor since = facts_.anchor();
  bool is_met = are_all_true(expect.conditions, facts_, since);
  const auto look = [&]() -> std::optional<Failure> {
    is_met = is_met || are_all_true(expect.conditions, facts_, since);
    return std::nullopt;
  };
  if (!advance(expect.within, look)) {
    return false;
  }
  if (!is_met) {
    failure_ =
        Failure{mark_of_first_untrue(expect.conditions, facts_, since),
                fmt::format("{} within {}", join_texts(expect.conditions), show(seconds(expect.within), Measure::time)),
                tell_seen(expect.conditions, facts_, since, false), world_.now()};
  }
  return is_met;
}

bool Runner::send(const Send& send) {
  hands_.begin_sending(send);
  const Time first = hands_.next_due().value_or(world_.now()) - world_.now();
  hands_.send_if_due();
  return !send.times || advance(first + send.every * *send.times);
}

}  // namespace simulation::scenario
