#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "simulation/monitor/clause.hpp"

namespace simulation::monitor {
namespace {

std::vector<Clause> gather() {
  std::vector<Clause> all;
  for (const auto& part : {motion_clauses(), brake_clauses(), report_clauses(), power_clauses(), bus_clauses()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end(),
            [](const Clause& one, const Clause& other) { return std::string_view(one.id) < other.id; });
  return all;
}

}  // namespace

const std::vector<Clause>& clauses() {
  static const std::vector<Clause> all = gather();
  return all;
}

const Clause* find_clause(const std::string& id) {
  const auto found =
      std::find_if(clauses().begin(), clauses().end(), [&](const Clause& clause) { return clause.id == id; });
  return found == clauses().end() ? nullptr : &*found;
}

std::string tell_clauses() {
  std::string text;
  for (const Clause& clause : clauses()) {
    text += fmt::format("{}  {}\n        judged: {}\n        for {}\n", clause.id, clause.says, clause.tolerance,
                        clause.stands_for);
  }
  return text;
}

}  // namespace simulation::monitor
