#include "simulation/scenario/given.hpp"

#include <fmt/format.h>

#include "simulation/scenario/parse_condition.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

// Woken up, handshake done, neutral seen long enough for every start-up delay.
constexpr Time waking_up = 700ms;
// From the stick's move to a steady speed.
constexpr Time speeding_up = 3s;

// These situations are written in the language itself.
std::vector<Condition> conditions(const std::string& yaml, Mark mark) {
  Problems none;
  auto parsed = parse_conditions(YAML::Load(yaml), none);
  for (Condition& condition : parsed) {
    condition.mark = mark;
  }
  return parsed;
}

Step make(Mark mark, const std::string& given, Action action) {
  return {mark, "given: " + given, std::move(action)};
}

void wake_up(std::vector<Step>& steps, Mark mark, const std::string& given) {
  steps.push_back(make(mark, given, PressPower{300ms}));
  steps.push_back(make(mark, given, Wait{waking_up - default_deadline}));
  steps.push_back(make(mark, given,
                       Expect{conditions("{answered: yes, drive inhibited: no, temporary drive modification: no,"
                                         " system state: System OK, chair: still}",
                                         mark),
                              default_deadline}));
}

void drive_off(std::vector<Step>& steps, Mark mark, const std::string& given, const YAML::Node& controls,
               Problems& problems) {
  const auto set = parse_controls(controls, problems);
  if (!set) {
    return;
  }
  steps.push_back(make(mark, given, *set));
  steps.push_back(make(mark, given, Wait{speeding_up - default_deadline}));
  steps.push_back(make(
      mark, given, Expect{conditions("{chair: moving, motors: driving, brakes: released}", mark), default_deadline}));
}

}  // namespace

std::vector<Step> parse_given(const YAML::Node& node, Problems& problems) {
  const auto given = read_text(node, problems);
  const Mark mark = mark_of(node);
  std::vector<Step> steps;
  if (!given || *given == "off") {
    return steps;
  }
  const std::string driving = "driving at ";
  if (given->starts_with(driving)) {
    wake_up(steps, mark, *given);
    YAML::Node controls;
    controls["speed"] = given->substr(driving.size());
    Problems of_speed;
    drive_off(steps, mark, *given, controls, of_speed);
    for (const Problem& problem : of_speed.sorted()) {
      problems.add(mark, problem.text);
    }
  } else if (*given == "awake") {
    wake_up(steps, mark, *given);
  } else if (*given == "awake with attendant") {
    steps.push_back(make(mark, *given, SetSacu{true}));
    wake_up(steps, mark, *given);
    steps.push_back(make(mark, *given, Expect{conditions("{SACU sends: general}", mark), default_deadline}));
  } else {
    problems.add(node, fmt::format("'{}' is not a start: off, awake, awake with attendant, driving at 60%", *given));
  }
  return steps;
}

}  // namespace simulation::scenario
