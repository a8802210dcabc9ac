// The table of all steps: how each is read, and what a person must know to write it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/reader.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

struct StepWord {
  std::string word;
  std::string example;  // one line, as it stands after "- " in a file
  std::string meaning;
  // `step` is the whole map, for companions such as `within`; `value` what stands after the word.
  std::optional<Action> (*parse)(const YAML::Node& value, Table& step, Problems& problems);
};

const std::vector<StepWord>& step_words();

// One thing that `sr:` can set.
struct ControlWord {
  std::string word;
  std::string example;
  std::string meaning;
  std::optional<std::function<void(RemoteControls&)>> (*parse)(const YAML::Node& value, Problems& problems);
};

const std::vector<ControlWord>& control_words();
std::optional<SetControls> parse_controls(const YAML::Node& node, Problems& problems);

// One thing that `remote:` or `sacu:` can set.
template <typename Set>
struct SettingWord {
  std::string word;
  std::string example;
  std::string meaning;
  void (*parse)(const YAML::Node& value, Set& set, Problems& problems);
};

const std::vector<SettingWord<SetRemote>>& remote_words();
const std::vector<SettingWord<SetSacu>>& sacu_words();
std::optional<Action> parse_remote(const YAML::Node& node, Problems& problems);
std::optional<Action> parse_sacu(const YAML::Node& node, Problems& problems);

// What `fault:` can do.
struct FaultWord {
  std::string word;
  std::string example;
  std::string meaning;
  // `fault` is the map under `fault:`, for companions such as `count`.
  std::optional<Action> (*parse)(const YAML::Node& value, Table& fault, Problems& problems);
};

const std::vector<FaultWord>& fault_words();

// A part of the chair that `fault:` breaks, until `restore:` with the same value.
struct DamageWord {
  std::string word;
  std::string example;  // the value
  std::string meaning;
  std::optional<Action> (*parse)(const YAML::Node& value, bool is_broken, Problems& problems);
};

const std::vector<DamageWord>& damage_words();
std::optional<Action> parse_restore(const YAML::Node& node, Problems& problems);
std::optional<Action> parse_fault(const YAML::Node& node, Problems& problems);

}  // namespace simulation::scenario
