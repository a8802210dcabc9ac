#include "simulation/scenario/parse_condition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/report/decode.hpp"
#include "simulation/scenario/spelling.hpp"

namespace simulation::scenario {
namespace {

const ConditionWord* find_word(const std::string& word) {
  const auto& words = condition_words();
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& row) { return row.word == word; });
  return found == words.end() ? nullptr : &*found;
}

// The words of a group ("chair") without it, or all words that stand alone.
std::vector<std::string> known_words(const std::string& group) {
  std::vector<std::string> known;
  for (const ConditionWord& row : condition_words()) {
    if (group.empty()) {
      known.push_back(row.word);
    } else if (row.word.starts_with(group + " ")) {
      known.push_back(row.word.substr(group.size() + 1));
    }
  }
  return known;
}

std::optional<Condition> parse_choice(const Choice& choice, const YAML::Node& value, Problems& problems) {
  std::vector<std::string> words;
  for (const auto& option : choice.options) {
    words.push_back(option.word);
  }
  const auto word = read_choice(value, words, problems);
  if (!word) {
    return std::nullopt;
  }
  const auto place = static_cast<std::size_t>(std::find(words.begin(), words.end(), *word) - words.begin());
  Condition condition;
  condition.holds = choice.options[place].is_true;
  condition.seen = [&choice](const Facts& facts, const Anchor& since) {
    std::vector<std::string> words;
    for (const auto& option : choice.options) {
      if (option.is_true(facts, since)) {
        words.push_back(option.word);
      }
    }
    return words.empty() ? std::string("nothing yet") : fmt::format("{}", fmt::join(words, ", "));
  };
  return condition;
}

std::optional<Condition> parse_gauge(const Gauge& gauge, const YAML::Node& value, Problems& problems) {
  const auto text = read_text(value, problems);
  if (!text) {
    return std::nullopt;
  }
  const auto parsed = parse_comparison(*text, gauge.measure);
  if (const auto* complaint = std::get_if<Complaint>(&parsed)) {
    problems.add(value, complaint->text);
    return std::nullopt;
  }
  Condition condition;
  condition.holds = [&gauge, wanted = std::get<Comparison>(parsed)](const Facts& facts, const Anchor& since) {
    const auto seen = gauge.read(facts, since);
    return seen && wanted.holds(*seen);
  };
  condition.seen = [&gauge](const Facts& facts, const Anchor& since) {
    const auto seen = gauge.read(facts, since);
    return seen ? show(*seen, gauge.measure) : std::string("nothing yet");
  };
  return condition;
}

std::string seen_since(Sender sender, const Facts& facts, const Anchor& since) {
  const auto& packets = facts.packets_of(sender);
  if (packets.empty() || packets.back().start < since.at) {
    return "nothing";
  }
  return fmt::format("{} last", report::hex(packets.back().bytes));
}

std::optional<Condition> parse_utterance(const Utterance& utterance, const YAML::Node& value, Problems& problems) {
  const auto text = read_text(value, problems);
  if (!text) {
    return std::nullopt;
  }
  std::vector<std::uint8_t> bytes;
  if (std::find(utterance.names.begin(), utterance.names.end(), *text) == utterance.names.end()) {
    const auto read = read_bytes(value, problems);
    if (!read) {
      return std::nullopt;
    }
    bytes = *read;
  }
  Condition condition;
  condition.holds = [bytes, name = *text, sender = utterance.sender](const Facts& facts, const Anchor& since) {
    const auto& packets = facts.packets_of(sender);
    for (auto packet = packets.rbegin(); packet != packets.rend() && packet->start >= since.at; ++packet) {
      if (bytes.empty() ? report::decode(*packet).name == name : packet->bytes == bytes) {
        return true;
      }
    }
    return false;
  };
  condition.seen = [sender = utterance.sender](const Facts& facts, const Anchor& since) {
    return seen_since(sender, facts, since);
  };
  return condition;
}

std::optional<Condition> parse_screen(const Screen& screen, const YAML::Node& value, Problems& problems) {
  const auto text = read_characters(value, problems);
  if (!text) {
    return std::nullopt;
  }
  Condition condition;
  condition.text = report::quote(*text);
  condition.holds = [&screen, wanted = *text](const Facts& facts, const Anchor&) {
    return screen.read(facts).find(wanted) != std::string::npos;
  };
  condition.seen = [&screen](const Facts& facts, const Anchor&) { return report::quote(screen.read(facts)); };
  return condition;
}

struct KindParser {
  const YAML::Node& value;
  Problems& problems;

  auto operator()(const Choice& choice) const { return parse_choice(choice, value, problems); }
  auto operator()(const Gauge& gauge) const { return parse_gauge(gauge, value, problems); }
  auto operator()(const Utterance& utterance) const { return parse_utterance(utterance, value, problems); }
  auto operator()(const Screen& screen) const { return parse_screen(screen, value, problems); }
};

void parse_pairs(const YAML::Node& node, const std::string& group, std::vector<Condition>& conditions,
                 Problems& problems) {
  for (const Pair& pair : read_pairs(node, group.empty() ? "a condition" : group, problems)) {
    const std::string word = group.empty() ? pair.key : group + " " + pair.key;
    if (group.empty() && pair.value.IsMap() && !known_words(word).empty()) {
      parse_pairs(pair.value, word, conditions, problems);
      continue;
    }
    const ConditionWord* row = find_word(word);
    if (row == nullptr) {
      problems.add(pair.key_node, fmt::format("unknown condition '{}'{}", word, suggest(pair.key, known_words(group))));
      continue;
    }
    if (auto condition = std::visit(KindParser{pair.value, problems}, row->kind)) {
      condition->mark = mark_of(pair.key_node);
      const std::string value = condition->text.empty() ? pair.value.Scalar() : condition->text;
      condition->text = fmt::format("{}: {}", word, value);
      conditions.push_back(std::move(*condition));
    }
  }
}

}  // namespace

std::vector<Condition> parse_conditions(const YAML::Node& node, Problems& problems) {
  std::vector<Condition> conditions;
  parse_pairs(node, "", conditions, problems);
  return conditions;
}

}  // namespace simulation::scenario
