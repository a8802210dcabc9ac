// What `expect`, `hold` and `never` ask about, and the table of all words they may use.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "simulation/report/facts.hpp"
#include "simulation/scenario/problem.hpp"
#include "simulation/scenario/quantity.hpp"

namespace simulation::scenario {

using report::Anchor;
using report::Facts;

struct Condition {
  Mark mark;
  std::string text;  // "motors: stopped"
  std::function<bool(const Facts&, const Anchor&)> holds;
  std::function<std::string(const Facts&, const Anchor&)> seen;  // what is true instead
};

// A word with a closed set of values.
struct Choice {
  struct Option {
    std::string word;
    std::function<bool(const Facts&, const Anchor&)> is_true;
  };
  std::vector<Option> options;
};

// A word whose value is a number; nothing while there is none.
struct Gauge {
  Measure measure;
  std::function<std::optional<double>(const Facts&, const Anchor&)> read;
};

// A packet that somebody has sent since the step began: a name, or bytes.
struct Utterance {
  Sender sender;
  std::vector<std::string> names;
};

// Characters that a person reads somewhere; the condition asks whether they hold a text.
struct Screen {
  std::function<const std::string&(const Facts&)> read;
};

struct ConditionWord {
  std::string word;     // "motors"; within a map of its own: "chair speed" is chair: {speed: ...}
  std::string example;  // "driving"
  std::string meaning;
  std::variant<Choice, Gauge, Utterance, Screen> kind;
};

const std::vector<ConditionWord>& condition_words();

}  // namespace simulation::scenario
