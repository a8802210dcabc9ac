#include "simulation/scenario/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "simulation/scenario/spelling.hpp"

namespace simulation::scenario {
namespace {

std::string kind_of(const YAML::Node& node) {
  return node.IsMap() ? "a map" : node.IsSequence() ? "a list" : "nothing";
}

std::optional<std::uint8_t> parse_byte(std::string_view word) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
  if (word.size() != 2 || error != std::errc() || end != word.data() + word.size()) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

Mark mark_of(const YAML::Node& node) {
  return {node.Mark().line + 1, node.Mark().column + 1};
}

std::vector<Problem> Problems::sorted() const {
  auto sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& one, const Problem& other) {
    return std::pair(one.mark.line, one.mark.column) < std::pair(other.mark.line, other.mark.column);
  });
  return sorted;
}

std::optional<std::string> read_text(const YAML::Node& node, Problems& problems) {
  if (!node.IsScalar()) {
    problems.add(node, fmt::format("expected a word or a text, found {}", kind_of(node)));
    return std::nullopt;
  }
  return node.Scalar();
}

std::optional<double> read_quantity(const YAML::Node& node, Measure measure, Problems& problems) {
  if (!node.IsScalar()) {
    problems.add(node, fmt::format("expected {}, found {}", example_of(measure), kind_of(node)));
    return std::nullopt;
  }
  const auto value = parse_quantity(node.Scalar(), measure);
  if (const auto* complaint = std::get_if<Complaint>(&value)) {
    problems.add(node, complaint->text);
    return std::nullopt;
  }
  return std::get<double>(value);
}

std::optional<Time> read_time(const YAML::Node& node, Problems& problems) {
  const auto value = read_quantity(node, Measure::time, problems);
  if (value && (*value < 0 || *value > 3600)) {
    problems.add(node, fmt::format("{} is out of range: 0s to 3600s", node.Scalar()));
    return std::nullopt;
  }
  return value ? std::optional(to_time(*value)) : std::nullopt;
}

std::optional<int> read_integer(const YAML::Node& node, int least, int most, Problems& problems) {
  const auto value = read_quantity(node, Measure::count, problems);
  if (!value) {
    return std::nullopt;
  }
  const bool is_in_range = *value >= least && *value <= most;
  if (!is_in_range || *value != static_cast<int>(*value)) {
    problems.add(node, fmt::format("{} must be a whole number from {} to {}", node.Scalar(), least, most));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<bool> read_switch(const YAML::Node& node, Problems& problems) {
  const std::string word = node.IsScalar() ? node.Scalar() : kind_of(node);
  if (word == "on" || word == "yes" || word == "true") {
    return true;
  }
  if (word == "off" || word == "no" || word == "false") {
    return false;
  }
  problems.add(node, fmt::format("expected on or off (or yes, no), found '{}'", word));
  return std::nullopt;
}

std::optional<std::string> read_choice(const YAML::Node& node, const std::vector<std::string>& words,
                                       Problems& problems) {
  const auto word = read_text(node, problems);
  if (!word || std::find(words.begin(), words.end(), *word) != words.end()) {
    return word;
  }
  problems.add(node, fmt::format("'{}' is not one of: {}", *word, fmt::join(words, ", ")));
  return std::nullopt;
}

std::optional<std::vector<std::uint8_t>> read_bytes(const YAML::Node& node, Problems& problems) {
  const auto text = read_text(node, problems);
  if (!text) {
    return std::nullopt;
  }
  std::vector<std::uint8_t> bytes;
  std::string_view rest = *text;
  while (!rest.empty()) {
    const auto word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (word.empty()) {
      continue;
    }
    const auto byte = parse_byte(word);
    if (!byte) {
      problems.add(node, fmt::format("'{}' is not a byte: write two hexadecimal digits, as in \"60 C0 0F\"", word));
      return std::nullopt;
    }
    bytes.push_back(*byte);
  }
  if (bytes.empty()) {
    problems.add(node, "expected bytes, as in \"60 C0 0F\"");
    return std::nullopt;
  }
  return bytes;
}

// YAML hands over UTF-8; the codes 0x80 to 0xFF are two bytes there.
std::optional<std::string> read_characters(const YAML::Node& node, Problems& problems) {
  const auto text = read_text(node, problems);
  if (!text) {
    return std::nullopt;
  }
  std::string characters;
  for (std::size_t i = 0; i < text->size(); ++i) {
    const unsigned lead = static_cast<std::uint8_t>((*text)[i]);
    if (lead < 0x80) {
      characters += (*text)[i];
    } else if (lead <= 0xC3 && i + 1 < text->size()) {
      const unsigned next = static_cast<std::uint8_t>((*text)[++i]);
      characters += static_cast<char>((lead & 0x03) << 6 | (next & 0x3F));
    } else {
      problems.add(node, "a character is beyond 0xFF: the programmer's have eight bits, as in \"a\\x83\"");
      return std::nullopt;
    }
  }
  if (characters.empty()) {
    problems.add(node, "expected characters, as in \"hello\\r\"");
    return std::nullopt;
  }
  return characters;
}

std::vector<std::string> read_texts(const YAML::Node& node, Problems& problems) {
  std::vector<std::string> texts;
  if (node.IsSequence()) {
    for (const auto& item : node) {
      texts.push_back(read_text(item, problems).value_or(""));
    }
  } else if (const auto text = read_text(node, problems)) {
    texts.push_back(*text);
  }
  return texts;
}

Table::Table(const YAML::Node& node, std::string what, Problems& problems)
    : node_(node), what_(std::move(what)), problems_(problems) {}

std::optional<YAML::Node> Table::find(const std::string& key) {
  known_.push_back(key);
  if (!node_.IsMap()) {
    return std::nullopt;
  }
  const YAML::Node& fixed = node_;
  const YAML::Node value = fixed[key];
  return value.IsDefined() ? std::optional(value) : std::nullopt;
}

std::optional<YAML::Node> Table::need(const std::string& key) {
  auto value = find(key);
  if (!value && node_.IsMap()) {
    problems_.add(node_, fmt::format("{} needs '{}'", what_, key));
  }
  return value;
}

void Table::done() {
  for (const Pair& pair : read_pairs(node_, what_, problems_)) {
    if (std::find(known_.begin(), known_.end(), pair.key) == known_.end()) {
      problems_.add(pair.key_node, fmt::format("{} has no '{}'{}", what_, pair.key, suggest(pair.key, known_)));
    }
  }
}

std::vector<Pair> read_pairs(const YAML::Node& node, const std::string& what, Problems& problems) {
  std::vector<Pair> pairs;
  if (!node.IsMap()) {
    problems.add(node, fmt::format("{} must be a map of 'word: value', found {}", what,
                                   node.IsScalar() ? fmt::format("'{}'", node.Scalar()) : kind_of(node)));
    return pairs;
  }
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const auto key = read_text(entry.first, problems);
    if (!key) {
      continue;
    }
    if (!seen.insert(*key).second) {
      problems.add(entry.first, fmt::format("'{}' stands here twice", *key));
    }
    pairs.push_back({*key, entry.first, entry.second});
  }
  return pairs;
}

}  // namespace simulation::scenario
