// Reading YAML strictly: every key must be known, every value of the right kind; whatever is wrong is noted
// with its place, and reading goes on, so that a file's problems come out all at once.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "simulation/scenario/problem.hpp"
#include "simulation/scenario/quantity.hpp"

namespace simulation::scenario {

Mark mark_of(const YAML::Node& node);

class Problems {
 public:
  void add(Mark mark, const std::string& text) { list_.push_back({mark, text}); }
  void add(const YAML::Node& node, const std::string& text) { add(mark_of(node), text); }
  bool empty() const { return list_.empty(); }
  std::vector<Problem> sorted() const;

 private:
  std::vector<Problem> list_;
};

// Each gives nothing, with a problem noted, if the node is not of that kind.
std::optional<std::string> read_text(const YAML::Node& node, Problems& problems);
std::optional<double> read_quantity(const YAML::Node& node, Measure measure, Problems& problems);
std::optional<Time> read_time(const YAML::Node& node, Problems& problems);  // never negative
std::optional<int> read_integer(const YAML::Node& node, int least, int most, Problems& problems);
std::optional<bool> read_switch(const YAML::Node& node, Problems& problems);  // on, off, yes, no
std::optional<std::string> read_choice(const YAML::Node& node, const std::vector<std::string>& words,
                                       Problems& problems);
std::optional<std::vector<std::uint8_t>> read_bytes(const YAML::Node& node, Problems& problems);  // "60 C0 0F"
// Characters of eight bits, one a byte: "a\r\x83" in double quotes.
std::optional<std::string> read_characters(const YAML::Node& node, Problems& problems);
std::vector<std::string> read_texts(const YAML::Node& node, Problems& problems);  // a list, or one text

// A map with named keys. Ask for what may be there, then call done().
class Table {
 public:
  Table(const YAML::Node& node, std::string what, Problems& problems);

  // The value, or nothing; the key counts as known from now on.
  std::optional<YAML::Node> find(const std::string& key);
  // As find(), but a missing key is a problem.
  std::optional<YAML::Node> need(const std::string& key);
  // Complains about keys nobody asked for.
  void done();

 private:
  YAML::Node node_;
  std::string what_;
  Problems& problems_;
  std::vector<std::string> known_;
};

// The pairs of a map in the order of the file; a scalar, a list or a repeated key is a problem.
struct Pair {
  std::string key;
  YAML::Node key_node;
  YAML::Node value;
};
std::vector<Pair> read_pairs(const YAML::Node& node, const std::string& what, Problems& problems);

}  // namespace simulation::scenario
