#include "simulation/scenario/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "simulation/monitor/clause.hpp"
#include "simulation/scenario/given.hpp"
#include "simulation/scenario/head_words.hpp"
#include "simulation/scenario/spelling.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

// One line of YAML, for reports.
std::string flow(const YAML::Node& node) {
  YAML::Emitter emitter;
  emitter << YAML::Flow << node;
  std::string text = emitter.c_str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

const StepWord* find_step(const std::string& word) {
  const auto& words = step_words();
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& row) { return row.word == word; });
  return found == words.end() ? nullptr : &*found;
}

std::vector<std::string> known_steps() {
  std::vector<std::string> known;
  for (const StepWord& row : step_words()) {
    known.push_back(row.word);
  }
  return known;
}

void complain_about_step(const YAML::Node& node, const std::string& word, Problems& problems) {
  problems.add(node, fmt::format("unknown step '{}'{}", word, suggest(word, known_steps())));
}

// "- wake"
std::optional<Step> parse_bare_step(const YAML::Node& node, Problems& problems) {
  const StepWord* row = find_step(node.Scalar());
  if (row == nullptr) {
    complain_about_step(node, node.Scalar(), problems);
    return std::nullopt;
  }
  if (row->example != row->word) {
    problems.add(node, fmt::format("step '{}' needs a value, as in '{}'", row->word, row->example));
    return std::nullopt;
  }
  Table nothing(node, row->word, problems);
  auto action = row->parse(YAML::Node(YAML::NodeType::Null), nothing, problems);
  return action ? std::optional(Step{mark_of(node), row->word, *action}) : std::nullopt;
}

std::optional<Step> parse_step(const YAML::Node& node, Problems& problems) {
  if (node.IsScalar()) {
    return parse_bare_step(node, problems);
  }
  const auto pairs = read_pairs(node, "a step", problems);
  if (pairs.empty()) {
    return std::nullopt;
  }
  // The step's word usually comes first; its companions (`within`, `for`) may stand before it.
  const auto pair = std::find_if(pairs.begin(), pairs.end(), [](const Pair& p) { return find_step(p.key) != nullptr; });
  if (pair == pairs.end()) {
    complain_about_step(pairs.front().key_node, pairs.front().key, problems);
    return std::nullopt;
  }
  const StepWord& row = *find_step(pair->key);
  Table step(node, fmt::format("step '{}'", row.word), problems);
  step.find(row.word);
  auto action = row.parse(pair->value, step, problems);
  step.done();
  return action ? std::optional(Step{mark_of(pair->key_node), flow(node), *action}) : std::nullopt;
}

std::vector<std::string> parse_clauses(const YAML::Node& node, Problems& problems) {
  static const std::regex shape("SB-[0-9A-F]{1,2}\\.[0-9]{1,2}|H-[0-9]{2}");
  auto clauses = read_texts(node, problems);
  for (const std::string& clause : clauses) {
    if (!std::regex_match(clause, shape)) {
      problems.add(node,
                   fmt::format("'{}' is neither a clause's id such as SB-2.15 nor a hazard's such as H-04", clause));
    }
  }
  return clauses;
}

std::vector<std::string> parse_needs(const YAML::Node& node, Problems& problems) {
  const auto boards = read_texts(node, problems);
  for (const std::string& board : boards) {
    if (board != "avr" && board != "host") {
      problems.add(node, fmt::format("'{}' is not a board: avr, host", board));
    }
  }
  return boards;
}

Exceptions parse_monitor(const YAML::Node& node, Problems& problems) {
  Exceptions exceptions;
  Table table(node, "'monitor'", problems);
  if (const auto except = table.need("except")) {
    exceptions.clauses = read_texts(*except, problems);
    for (const std::string& id : exceptions.clauses) {
      if (monitor::find_clause(id) == nullptr) {
        problems.add(*except, fmt::format("'{}' is no clause of the monitor, such as H-04.1: see list-clauses", id));
      }
    }
  }
  if (const auto because = table.need("because")) {
    exceptions.because = read_text(*because, problems).value_or("");
    if (exceptions.because.empty()) {
      problems.add(*because, "say why the clauses may be broken");
    }
  }
  table.done();
  return exceptions;
}

void parse_steps(const YAML::Node& node, Scenario& scenario, Problems& problems) {
  if (!node.IsSequence()) {
    problems.add(node, "'steps' must be a list: each step on a line of its own after '- '");
    return;
  }
  for (const auto& item : node) {
    if (auto step = parse_step(item, problems)) {
      scenario.steps.push_back(std::move(*step));
    }
  }
}

Scenario parse_root(const YAML::Node& root, const std::string& file, Problems& problems) {
  Scenario scenario;
  scenario.file = file;
  if (!root.IsMap()) {
    problems.add(Mark{}, "a scenario is a map with the keys name, spec, given, steps (see docs/simulation.md)");
    return scenario;
  }
  Table table(root, "a scenario", problems);
  if (const auto name = table.need("name")) {
    scenario.name = read_text(*name, problems).value_or("");
  }
  if (const auto about = table.find("about")) {
    scenario.about = read_text(*about, problems).value_or("");
  }
  if (const auto spec = table.find("spec")) {
    scenario.spec = parse_clauses(*spec, problems);
  }
  if (const auto tags = table.find("tags")) {
    scenario.tags = read_texts(*tags, problems);
  }
  if (const auto seed = table.find("seed")) {
    scenario.seed = read_integer(*seed, 0, 2147483647, problems);
  }
  if (const auto needs = table.find("needs")) {
    scenario.needs = parse_needs(*needs, problems);
  }
  if (const auto monitor = table.find("monitor")) {
    scenario.exceptions = parse_monitor(*monitor, problems);
  }
  for (const HeadWord& row : head_words()) {
    if (const auto value = table.find(row.word)) {
      row.parse(*value, scenario.module, problems);
    }
  }
  if (const auto given = table.find("given")) {
    scenario.steps = parse_given(*given, problems);
  }
  if (const auto steps = table.need("steps")) {
    parse_steps(*steps, scenario, problems);
  }
  table.done();
  return scenario;
}

}  // namespace

Scenario parse_scenario(const std::string& text, const std::string& file) {
  Problems problems;
  Scenario scenario;
  try {
    scenario = parse_root(YAML::Load(text), file, problems);
  } catch (const YAML::ParserException& error) {
    problems.add(Mark{error.mark.line + 1, error.mark.column + 1},
                 fmt::format("not YAML: {} (a value that begins with > or < or % needs quotes)", error.msg));
  }
  if (!problems.empty()) {
    throw BadScenario(file, problems.sorted());
  }
  return scenario;
}

Scenario load_scenario(const std::string& file) {
  std::ifstream in(file);
  std::stringstream text;
  if (!in || !(text << in.rdbuf())) {
    throw BadScenario(file, {{Mark{}, "cannot be read"}});
  }
  return parse_scenario(text.str(), file);
}

}  // namespace simulation::scenario
