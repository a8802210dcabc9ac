#include "simulation/scenario/problem.hpp"

#include <fmt/format.h>

namespace simulation::scenario {
namespace {

std::string show_all(const std::string& file, const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + show(file, problem);
  }
  return text;
}

}  // namespace

std::string show(const std::string& file, const Problem& problem) {
  if (problem.mark.line == 0) {
    return fmt::format("{}: {}", file, problem.text);
  }
  return fmt::format("{}:{}:{}: {}", file, problem.mark.line, problem.mark.column, problem.text);
}

BadScenario::BadScenario(const std::string& file, std::vector<Problem> problems)
    : std::runtime_error(show_all(file, problems)), problems_(std::move(problems)) {}

}  // namespace simulation::scenario
