// `remote:` and `sacu:`, the modules themselves: kind, clock and habits; with the hands on the attendant control.
#include <fmt/format.h>

#include <algorithm>

#include "simulation/scenario/control_values.hpp"
#include "simulation/scenario/spelling.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

constexpr double nominal_bit_us = 1e6 / 38400;
constexpr double widest_rate_error = 0.1;

// ---- what both have

template <typename Module>
constexpr const char* name_of = nullptr;
template <>
constexpr const char* name_of<Remote> = "the remote";
template <>
constexpr const char* name_of<Sacu> = "the attendant control";

template <typename Module>
struct SetOf;
template <>
struct SetOf<Remote> {
  using Type = SetRemote;
};
template <>
struct SetOf<Sacu> {
  using Type = SetSacu;
};

// "the remote" and what it does
template <typename Module>
void add_habit(typename SetOf<Module>::Type& set, std::function<void(Module&)> change, const std::string& what) {
  set.habits.push_back({std::move(change), fmt::format("{} {}", name_of<Module>, what)});
}

std::string tell_rate(double share) {
  return share == 0 ? std::string("keeps the bit rate")
                    : fmt::format("is {} {}", show(std::abs(share), Measure::share), share > 0 ? "fast" : "slow");
}

template <typename Module>
void set_bit_rate(const YAML::Node& value, typename SetOf<Module>::Type& set, Problems& problems) {
  const auto share = read_quantity(value, Measure::share, problems);
  if (share && std::abs(*share) > widest_rate_error) {
    problems.add(value, fmt::format("{} is out of range: -10% to +10%", value.Scalar()));
  } else if (share) {
    add_habit<Module>(
        set, [v = nominal_bit_us / (1 + *share)](Module& module) { module.timing.bit_us = v; }, tell_rate(*share));
  }
}

template <typename Module>
void set_stop_bits(const YAML::Node& value, typename SetOf<Module>::Type& set, Problems& problems) {
  if (const auto number = read_integer(value, 1, 2, problems)) {
    add_habit<Module>(
        set, [v = *number](Module& module) { module.timing.stop_bits = v; },
        *number == 1 ? "sends one stop bit" : "sends two stop bits");
  }
}

template <typename Module>
void set_gap(const YAML::Node& value, typename SetOf<Module>::Type& set, Problems& problems) {
  if (const auto gap = read_time(value, problems)) {
    add_habit<Module>(
        set, [v = *gap](Module& module) { module.timing.gap = v; },
        *gap == Time{} ? std::string("sends back to back")
                       : fmt::format("pauses for {} between bytes", show(seconds(*gap), Measure::time)));
  }
}

template <typename Module>
void set_calibration_packets(const YAML::Node& value, typename SetOf<Module>::Type& set, Problems& problems) {
  if (const auto is_on = read_switch(value, problems)) {
    add_habit<Module>(
        set, [v = *is_on](Module& module) { module.sends_calibration = v; },
        *is_on ? "sends calibration packets" : "sends calibration packets only while it calibrates");
  }
}

template <typename Set>
Set read_settings(const YAML::Node& node, const std::string& what, const std::vector<SettingWord<Set>>& words,
                  Problems& problems) {
  std::vector<std::string> known;
  for (const auto& row : words) {
    known.push_back(row.word);
  }
  Set set;
  for (const Pair& pair : read_pairs(node, what, problems)) {
    const auto place = std::find(known.begin(), known.end(), pair.key);
    if (place == known.end()) {
      problems.add(pair.key_node, fmt::format("{} has no '{}'{}", what, pair.key, suggest(pair.key, known)));
      continue;
    }
    words[static_cast<std::size_t>(place - known.begin())].parse(pair.value, set, problems);
  }
  return set;
}

// ---- the remote

void set_remote_talks(const YAML::Node& value, SetRemote& set, Problems& problems) {
  set.talks = read_switch(value, problems);
}

void set_period(const YAML::Node& value, SetRemote& set, Problems& problems) {
  set.period = read_time(value, problems);
}

template <int RemoteIdentity::*member, int least, int most>
void set_identity(const YAML::Node& value, SetRemote& set, Problems& problems) {
  if (const auto number = read_integer(value, least, most, problems)) {
    set.changes.push_back([v = *number](RemoteIdentity& identity) { identity.*member = v; });
  }
}

// ---- the attendant control

template <int SacuControls::*member>
void set_axis(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto reading = read_axis(value, problems)) {
    set.changes.push_back([v = *reading](SacuControls& controls) { controls.*member = v; });
  }
}

void set_sacu_pot(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto reading = read_pot(value, problems)) {
    set.changes.push_back([v = *reading](SacuControls& controls) { controls.pot = v; });
  }
}

template <int SacuControls::*member, int most>
void set_raw(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto number = read_integer(value, 0, most, problems)) {
    set.changes.push_back([v = *number](SacuControls& controls) { controls.*member = v; });
  }
}

template <bool SacuControls::*member>
void set_switch(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto is_on = read_switch(value, problems)) {
    set.changes.push_back([v = *is_on](SacuControls& controls) { controls.*member = v; });
  }
}

void set_sacu_talks(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto talks = read_switch(value, problems)) {
    add_habit<Sacu>(
        set, [v = !*talks](Sacu& sacu) { sacu.is_silent = v; }, *talks ? "talks" : "is silent");
  }
}

void set_insists(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto insists = read_switch(value, problems)) {
    add_habit<Sacu>(
        set, [v = *insists](Sacu& sacu) { sacu.insists = v; },
        *insists ? "sends generals, acknowledged or not" : "waits to be acknowledged");
  }
}

void set_follows(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto whom = read_choice(value, {"SPM", "SR"}, problems)) {
    add_habit<Sacu>(
        set, [v = *whom == "SR"](Sacu& sacu) { sacu.timing.is_rash = v; },
        *whom == "SR" ? "speaks after the remote, into the power module's turn" : "speaks after the power module");
  }
}

void set_pause(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto pause = read_time(value, problems)) {
    add_habit<Sacu>(
        set, [v = *pause](Sacu& sacu) { sacu.timing.pause = v; },
        fmt::format("speaks {} after whom it follows", show(seconds(*pause), Measure::time)));
  }
}

template <int SacuIdentity::*member, int least = 0, int most = 127>
void set_sacu_identity(const YAML::Node& value, SetSacu& set, Problems& problems) {
  if (const auto number = read_integer(value, least, most, problems)) {
    add_habit<Sacu>(
        set, [v = *number](Sacu& sacu) { sacu.identity.*member = v; }, "is of another kind");
  }
}

}  // namespace

const std::vector<SettingWord<SetRemote>>& remote_words() {
  using I = RemoteIdentity;
  static const std::vector<SettingWord<SetRemote>> words{
      {"talks", "no", "whether it sends anything at all", set_remote_talks},
      {"period", "66ms", "from turn to turn", set_period},
      {"bit rate", "+2%", "its clock, fast or slow (-2%); its receiver's, too", set_bit_rate<Remote>},
      {"stop bits", "1", "1 or 2", set_stop_bits<Remote>},
      {"gap", "1300us", "idle line between the bytes of a turn", set_gap<Remote>},
      {"calibration packets", "on", "its calibration packet in every turn, calibration or not",
       set_calibration_packets<Remote>},
      {"general length", "6", "data bytes of its general, 6 (an old remote) or 7",
       set_identity<&I::general_length, 6, 7>},
      {"power-up length", "6", "data bytes of its power-up packet, 6 to 8", set_identity<&I::power_up_length, 6, 8>},
      {"type", "2", "remote type, as on the wire", set_identity<&I::type, 0, 127>},
      {"year", "2006", "of manufacture", set_identity<&I::year, 2000, 2127>},
      {"month", "11", "of manufacture, 1 to 12", set_identity<&I::month, 1, 12>},
      {"serial", "4810", "serial number, 0 to 2097151", set_identity<&I::serial, 0, 2097151>},
      {"version", "37", "software version, as on the wire", set_identity<&I::version, 0, 127>},
      {"capabilities", "3", "as on the wire: 4 analog pot, 2 actuators, 1 lighting",
       set_identity<&I::capabilities, 0, 127>},
  };
  return words;
}

const std::vector<SettingWord<SetSacu>>& sacu_words() {
  using C = SacuControls;
  static const std::vector<SettingWord<SetSacu>> words{
      {"speed", "40%", "stick forward (back: -40%), share of its travel, or neutral", set_axis<&C::speed>},
      {"direction", "-30%", "stick to the right (left: negative), share of its travel, or neutral",
       set_axis<&C::direction>},
      {"pot", "100%", "speed pot", set_sacu_pot},
      {"speed raw", "830", "the reading itself, 0 to 1023", set_raw<&C::speed, full_reading>},
      {"direction raw", "512", "the reading itself, 0 to 1023", set_raw<&C::direction, full_reading>},
      {"pot raw", "255", "the reading itself, 0 to 255", set_raw<&C::pot, full_pot>},
      {"attendant", "on", "the switch: the attendant wants to drive", set_switch<&C::is_attendant>},
      {"joystick error", "on", "it reports a joystick error", set_switch<&C::joystick_error>},
      {"pot error", "on", "it reports a pot error", set_switch<&C::pot_error>},
      {"local fault", "on", "it reports a fault of its own", set_switch<&C::local_fault>},
      {"non-critical fault", "on", "it reports a fault that limps", set_switch<&C::non_critical_fault>},
      {"calibration", "on", "its joystick calibration is active; it sends calibration packets, too",
       set_switch<&C::calibration_active>},
      {"second pass", "on", "of the calibration", set_switch<&C::calibration_second_pass>},
      {"drive inhibit", "on", "nobody shall drive", set_switch<&C::drive_inhibit>},
      {"mode", "1", "requested operating mode, 0 to 15", set_raw<&C::mode, 15>},
      {"talks", "no", "whether it sends anything at all", set_sacu_talks},
      {"insists", "on", "sends generals without having been acknowledged", set_insists},
      {"follows", "SR", "whose TF it takes its turn after: SPM, or SR for one that speaks into the SPM's turn",
       set_follows},
      {"pause", "100us", "from that TF to its turn", set_pause},
      {"bit rate", "+2%", "its clock, fast or slow (-2%); its receiver's, too", set_bit_rate<Sacu>},
      {"stop bits", "1", "1 or 2", set_stop_bits<Sacu>},
      {"gap", "200us", "idle line between the bytes of a turn", set_gap<Sacu>},
      {"calibration packets", "on", "its calibration packet in every turn, calibration or not",
       set_calibration_packets<Sacu>},
      {"year", "2010", "of manufacture", set_sacu_identity<&SacuIdentity::year, 2000, 2127>},
      {"month", "9", "of manufacture, 1 to 12", set_sacu_identity<&SacuIdentity::month, 1, 12>},
      {"serial", "1545925", "serial number, 0 to 2097151", set_sacu_identity<&SacuIdentity::serial, 0, 2097151>},
      {"version", "37", "software version, as on the wire", set_sacu_identity<&SacuIdentity::version>},
      {"capabilities", "7", "as on the wire: 4 actuator 2, 2 actuator 1, 1 speed control",
       set_sacu_identity<&SacuIdentity::capabilities>},
  };
  return words;
}

std::optional<Action> parse_remote(const YAML::Node& value, Problems& problems) {
  if (value.IsScalar()) {
    const auto word = read_choice(value, {"silent", "talks"}, problems);
    return word ? std::optional<Action>(SetRemote{*word == "talks", std::nullopt}) : std::nullopt;
  }
  return read_settings(value, "remote", remote_words(), problems);
}

std::optional<Action> parse_sacu(const YAML::Node& value, Problems& problems) {
  if (value.IsScalar()) {
    const auto word = read_choice(value, {"attached", "detached"}, problems);
    return word ? std::optional<Action>(SetSacu{*word == "attached"}) : std::nullopt;
  }
  return read_settings(value, "sacu", sacu_words(), problems);
}

}  // namespace simulation::scenario
