// `sr:`, the hands on the remote.
#include <fmt/format.h>

#include <algorithm>

#include "simulation/scenario/control_values.hpp"
#include "simulation/scenario/spelling.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

using Change = std::function<void(RemoteControls&)>;

template <int RemoteControls::*member>
std::optional<Change> set_axis(const YAML::Node& value, Problems& problems) {
  const auto reading = read_axis(value, problems);
  return reading ? std::optional<Change>([v = *reading](RemoteControls& c) { c.*member = v; }) : std::nullopt;
}

std::optional<Change> set_pot(const YAML::Node& value, Problems& problems) {
  const auto reading = read_pot(value, problems);
  return reading ? std::optional<Change>([v = *reading](RemoteControls& c) { c.pot = v; }) : std::nullopt;
}

template <int RemoteControls::*member, int most>
std::optional<Change> set_raw(const YAML::Node& value, Problems& problems) {
  const auto number = read_integer(value, 0, most, problems);
  return number ? std::optional<Change>([v = *number](RemoteControls& c) { c.*member = v; }) : std::nullopt;
}

template <bool RemoteControls::*member>
std::optional<Change> set_switch(const YAML::Node& value, Problems& problems) {
  const auto is_on = read_switch(value, problems);
  return is_on ? std::optional<Change>([v = *is_on](RemoteControls& c) { c.*member = v; }) : std::nullopt;
}

}  // namespace

const std::vector<ControlWord>& control_words() {
  using C = RemoteControls;
  static const std::vector<ControlWord> words{
      {"speed", "60%", "stick forward (back: -60%), share of its travel, or neutral", set_axis<&C::speed>},
      {"direction", "-30%", "stick to the right (left: negative), share of its travel, or neutral",
       set_axis<&C::direction>},
      {"pot", "100%", "speed pot", set_pot},
      {"speed raw", "830", "the reading itself, 0 to 1023", set_raw<&C::speed, full_reading>},
      {"direction raw", "512", "the reading itself, 0 to 1023", set_raw<&C::direction, full_reading>},
      {"pot raw", "255", "the reading itself, 0 to 255", set_raw<&C::pot, full_pot>},
      {"power button", "on", "held down while on", set_switch<&C::power_button>},
      {"horn", "on", "horn switch", set_switch<&C::horn>},
      {"lock", "on", "lock switch", set_switch<&C::lock>},
      {"hazard", "on", "hazard light request", set_switch<&C::hazard>},
      {"left", "on", "left indicator request", set_switch<&C::left_indicator>},
      {"right", "on", "right indicator request", set_switch<&C::right_indicator>},
      {"headlight", "on", "headlight request", set_switch<&C::headlight>},
      {"joystick error", "on", "the remote reports a joystick error", set_switch<&C::joystick_error>},
      {"pot error", "on", "the remote reports a pot error", set_switch<&C::pot_error>},
      {"local fault", "on", "the remote reports a fault of its own", set_switch<&C::local_fault>},
      {"non-critical fault", "on", "the remote reports a fault that limps", set_switch<&C::non_critical_fault>},
      {"charger inhibit", "on", "a charger is plugged in", set_switch<&C::charger_inhibit>},
      {"remote inhibit", "on", "the remote forbids driving", set_switch<&C::remote_inhibit>},
      {"calibration", "on", "joystick calibration is active", set_switch<&C::calibration_active>},
      {"second pass", "on", "of the joystick calibration", set_switch<&C::calibration_second_pass>},
      {"HHP may send", "off", "flow control of the programmer tunnel", set_switch<&C::hhp_may_send>},
      {"mode", "1", "requested operating mode, 0 to 15", set_raw<&C::mode, 15>},
  };
  return words;
}

std::optional<SetControls> parse_controls(const YAML::Node& node, Problems& problems) {
  std::vector<std::string> known;
  for (const ControlWord& row : control_words()) {
    known.push_back(row.word);
  }
  SetControls controls;
  for (const Pair& pair : read_pairs(node, "sr", problems)) {
    const auto place = std::find(known.begin(), known.end(), pair.key);
    if (place == known.end()) {
      problems.add(pair.key_node, fmt::format("sr has no '{}'{}", pair.key, suggest(pair.key, known)));
      continue;
    }
    const ControlWord& row = control_words()[static_cast<std::size_t>(place - known.begin())];
    if (auto change = row.parse(pair.value, problems)) {
      controls.changes.push_back(std::move(*change));
    }
  }
  return controls;
}

}  // namespace simulation::scenario
