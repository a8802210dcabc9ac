// The table itself.
#include <catch2/catch.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "simulation/monitor/clause.hpp"

namespace {

using namespace simulation::monitor;

std::string hazards_page() {
  std::ifstream in(std::string(PILOTFISH_SCENARIO_DIR) + "/../../docs/hazards.md");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("every clause has an id of its own, words, a tolerance and what it stands for", "[monitor]") {
  const std::regex shape("H-[0-9]{2}\\.[0-9]");
  std::set<std::string> ids;
  for (const Clause& clause : clauses()) {
    CAPTURE(clause.id);
    CHECK(std::regex_match(clause.id, shape));
    CHECK(ids.insert(clause.id).second);
    CHECK(std::string(clause.says).size() > 10);
    CHECK_FALSE(std::string(clause.tolerance).empty());
    CHECK(std::string(clause.stands_for).starts_with("SB-"));
    CHECK(find_clause(clause.id) == &clause);
  }
  CHECK(find_clause("H-99.9") == nullptr);
}

TEST_CASE("the page of hazards names exactly the clauses there are", "[monitor]") {
  const std::string page = hazards_page();
  const std::regex mention("H-[0-9]{2}\\.[0-9]");
  std::set<std::string> named;
  for (std::sregex_iterator at(page.begin(), page.end(), mention); at != std::sregex_iterator(); ++at) {
    named.insert(at->str());
  }
  std::set<std::string> known;
  for (const Clause& clause : clauses()) {
    known.insert(clause.id);
  }
  CHECK(named == known);
}
