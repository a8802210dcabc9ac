#include "simulation/scenario/lexicon.hpp"

#include <fmt/format.h>

#include "simulation/eeprom/settings.hpp"
#include "simulation/scenario/condition.hpp"
#include "simulation/scenario/head_words.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

std::string tell_values(const ConditionWord& row) {
  if (const auto* choice = std::get_if<Choice>(&row.kind)) {
    std::vector<std::string> words;
    for (const auto& option : choice->options) {
      words.push_back(option.word);
    }
    return fmt::format("{}", fmt::join(words, " | "));
  }
  if (const auto* gauge = std::get_if<Gauge>(&row.kind)) {
    return example_of(gauge->measure) + ", after <, <=, >, >=, != or alone";
  }
  return "";
}

// A second line of an example, such as `within:`, below the first one's words.
std::string indented(const std::string& example) {
  std::string text;
  for (const char character : example) {
    text += character;
    if (character == '\n') {
      text += "  ";
    }
  }
  return text;
}

// "chair speed" is written chair: {speed: ...}
std::string write_condition(const ConditionWord& row) {
  const std::string value = std::holds_alternative<Gauge>(row.kind) ? '"' + row.example + '"' : row.example;
  if (row.word.starts_with("chair ")) {
    return fmt::format("chair: {{{}: {}}}", row.word.substr(6), value);
  }
  return fmt::format("{}: {}", row.word, value);
}

template <typename Words>
std::string tell_settings(const char* step, const Words& words) {
  std::string text = fmt::format("\nThings that '{}:' sets\n\n", step);
  for (const auto& row : words) {
    text += fmt::format("  {:<28} {}\n", fmt::format("{}: {}", row.word, row.example), row.meaning);
  }
  return text;
}

std::string tell_head() {
  std::string text = "At the head of a scenario, beside name, about, spec, tags, given, seed, needs, monitor\n\n";
  for (const HeadWord& row : head_words()) {
    text += fmt::format("  {}\n        {}\n", row.example, row.meaning);
  }
  text += "\nThings that 'settings:' sets: default, range, unit\n\n";
  for (const auto& row : eeprom::known_settings()) {
    text += fmt::format("  {:<28} {}, {} to {} {}\n", row.name, row.initial, row.least, row.most, row.unit);
  }
  return text;
}

}  // namespace

std::string tell_lexicon() {
  std::string text = tell_head();
  text += "\nSteps, each after '- ' in the list under 'steps:'\n\n";
  for (const StepWord& row : step_words()) {
    text += fmt::format("  - {}\n        {}\n", indented(row.example), row.meaning);
  }
  text += tell_settings("sr", control_words());
  text += tell_settings("remote", remote_words());
  text += tell_settings("sacu", sacu_words());
  text += "\nFaults\n\n";
  for (const FaultWord& row : fault_words()) {
    text += fmt::format("  - {}\n        {}\n", row.example, row.meaning);
  }
  for (const DamageWord& row : damage_words()) {
    text += fmt::format("  - fault: {{{}: {}}}\n        {}, until 'restore'\n", row.word, row.example, row.meaning);
  }
  text += "\nConditions, in the maps under 'expect', 'hold' and 'never'\n\n";
  for (const ConditionWord& row : condition_words()) {
    const std::string values = tell_values(row);
    text +=
        fmt::format("  {}\n        {}{}{}\n", write_condition(row), row.meaning, values.empty() ? "" : ": ", values);
  }
  text += fmt::format("\nUnits: {}; {}; {}; {}; {}; {}.\n", example_of(Measure::time), example_of(Measure::speed),
                      example_of(Measure::length), example_of(Measure::angle), example_of(Measure::voltage),
                      example_of(Measure::share));
  return text;
}

}  // namespace simulation::scenario
