// The parts of the chair that `fault:` breaks and `restore:` mends.
#include <fmt/format.h>

#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

using Parsed = std::optional<Action>;

Parsed read_side(Damage damage, bool is_broken, const YAML::Node& value, Problems& problems) {
  const auto side = read_choice(value, {"left", "right"}, problems);
  return side ? Parsed(Break{damage, *side == "left" ? Side::left : Side::right, is_broken}) : std::nullopt;
}

Parsed read_lamp(LampDamage damage, bool is_broken, const YAML::Node& value, Problems& problems) {
  const auto lamp = read_choice(value, {"left indicator", "right indicator", "headlight"}, problems);
  if (!lamp) {
    return std::nullopt;
  }
  const LampPlace place = *lamp == "left indicator"    ? LampPlace::left_indicator
                          : *lamp == "right indicator" ? LampPlace::right_indicator
                                                       : LampPlace::headlight;
  return BreakLamp{damage, place, is_broken};
}

Parsed read_actuator(ActuatorDamage damage, bool is_broken, const YAML::Node& value, Problems& problems) {
  const auto number = read_integer(value, 1, 2, problems);
  return number ? Parsed(BreakActuator{damage, *number, is_broken}) : std::nullopt;
}

template <Damage damage>
Parsed break_part(const YAML::Node& value, bool is_broken, Problems& problems) {
  return read_side(damage, is_broken, value, problems);
}

template <LampDamage damage>
Parsed break_lamp(const YAML::Node& value, bool is_broken, Problems& problems) {
  return read_lamp(damage, is_broken, value, problems);
}

template <ActuatorDamage damage>
Parsed break_actuator(const YAML::Node& value, bool is_broken, Problems& problems) {
  return read_actuator(damage, is_broken, value, problems);
}

}  // namespace

const std::vector<DamageWord>& damage_words() {
  static const std::vector<DamageWord> words{
      {"open brake coil", "left", "the wire is off: no current, and that park brake stays engaged",
       break_part<Damage::open_coil>},
      {"shorted brake coil", "right", "it draws 3 A and lifts nothing", break_part<Damage::shorted_coil>},
      {"stuck bridge", "right", "that motor has the full supply, forward, while the motor relay is closed",
       break_part<Damage::stuck_bridge>},
      {"open motor", "left", "the wire is off: no current", break_part<Damage::open_motor>},
      {"blocked wheel", "left", "that wheel stands against a kerb: it cannot turn forward",
       break_part<Damage::blocked_wheel>},
      {"open lamp", "left indicator", "the wire is off: no current; or right indicator, or headlight",
       break_lamp<LampDamage::open>},
      {"shorted lamp", "headlight", "it draws 8 A while it is on; or left indicator, or right indicator",
       break_lamp<LampDamage::shorted>},
      {"open actuator", "1", "the wire is off: no current", break_actuator<ActuatorDamage::open>},
      {"shorted actuator", "2", "it draws 20 A while it is on, and does not move",
       break_actuator<ActuatorDamage::shorted>},
      {"blocked actuator", "1", "it stalls with 9 A while it is on", break_actuator<ActuatorDamage::blocked>},
      {"no end switch", "1", "that actuator stalls with 9 A at the ends of its travel",
       break_actuator<ActuatorDamage::no_end_switch>},
  };
  return words;
}

Parsed parse_restore(const YAML::Node& node, Problems& problems) {
  if (!node.IsMap()) {
    return read_choice(node, {"cable"}, problems) ? Parsed(MendCable{}) : std::nullopt;
  }
  Table restore(node, "restore", problems);
  Parsed action;
  for (const DamageWord& row : damage_words()) {
    if (const auto value = restore.find(row.word); value && !action) {
      action = row.parse(*value, false, problems);
    }
  }
  if (!action && node.size() == 0) {
    problems.add(node, "restore what? write 'restore: cable' or 'restore: {stuck bridge: right}'");
  }
  restore.done();
  return action;
}

}  // namespace simulation::scenario
