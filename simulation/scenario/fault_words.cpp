// `fault:`, what goes wrong on the wire and in the chip.
#include <fmt/format.h>

#include <algorithm>

#include "bus/shark/frame.hpp"
#include "simulation/scenario/spelling.hpp"
#include "simulation/scenario/step_words.hpp"

namespace simulation::scenario {
namespace {

struct Victim {
  const char* name;
  Sender sender;
  std::uint8_t start_nibble;
};

std::uint8_t nibble(bus::shark::Type type) {
  return static_cast<std::uint8_t>(type);
}

const std::vector<Victim>& victims() {
  using bus::shark::Type;
  static const std::vector<Victim> rows{
      {"SR general", Sender::sr, nibble(Type::sr_general)},
      {"SR power-up", Sender::sr, nibble(Type::sr_power_up)},
      {"SR TF", Sender::sr, bus::shark::transmit_finished},
      {"SR HHP data", Sender::sr, nibble(Type::sr_hhp_data)},
      {"SR calibration", Sender::sr, nibble(Type::joystick_calibration)},
      {"SPM general", Sender::spm, nibble(Type::spm_general)},
      {"SPM power-up", Sender::spm, nibble(Type::spm_power_up)},
      {"SPM settings", Sender::spm, nibble(Type::spm_settings)},
      {"SPM HHP data", Sender::spm, nibble(Type::spm_hhp_data)},
      {"SPM TF", Sender::spm, bus::shark::transmit_finished},
      {"SACU general", Sender::sacu, nibble(Type::sacu_general)},
      {"SACU power-up", Sender::sacu, nibble(Type::sacu_power_up)},
      {"SACU calibration", Sender::sacu, nibble(Type::joystick_calibration)},
      {"SACU TF", Sender::sacu, bus::shark::transmit_finished},
  };
  return rows;
}

std::optional<Disturb> read_disturbance(Disturb::Way way, const YAML::Node& value, Table& fault, Problems& problems) {
  std::vector<std::string> names;
  for (const Victim& victim : victims()) {
    names.push_back(victim.name);
  }
  Disturb disturb;
  disturb.way = way;
  if (const auto count = fault.find("count")) {
    disturb.count = read_integer(*count, 1, 1000000, problems).value_or(1);
  }
  const auto name = read_choice(value, names, problems);
  if (!name) {
    return std::nullopt;
  }
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), *name) - names.begin());
  disturb.sender = victims()[place].sender;
  disturb.start_nibble = victims()[place].start_nibble;
  return disturb;
}

std::optional<Action> cut(const YAML::Node& value, Table&, Problems& problems) {
  if (value.IsMap() && value.size() > 0) {
    problems.add(value, "cut cable takes nothing: write 'fault: cut cable'");
  }
  return CutCable{};
}

std::optional<Action> corrupt(const YAML::Node& value, Table& fault, Problems& problems) {
  return read_disturbance(Disturb::Way::corrupt_checksum, value, fault, problems);
}

std::optional<Action> flip(const YAML::Node& value, Table& fault, Problems& problems) {
  const auto byte = fault.need("byte");
  const auto bit = fault.need("bit");
  auto disturb = read_disturbance(Disturb::Way::flip_bit, value, fault, problems);
  if (!disturb || !byte || !bit) {
    return std::nullopt;
  }
  disturb->byte = read_integer(*byte, 0, 9, problems).value_or(0);
  disturb->bit = read_integer(*bit, 0, 7, problems).value_or(0);
  return disturb;
}

std::optional<Action> drop(const YAML::Node& value, Table& fault, Problems& problems) {
  auto disturb = read_disturbance(Disturb::Way::drop, value, fault, problems);
  const auto byte = fault.find("byte");
  if (disturb && byte) {
    disturb->byte = read_integer(*byte, 0, 9, problems).value_or(0);
  }
  return disturb;
}

std::optional<Action> break_stop_bit(const YAML::Node& value, Table& fault, Problems& problems) {
  auto disturb = read_disturbance(Disturb::Way::framing_error, value, fault, problems);
  const auto byte = fault.find("byte");
  if (disturb && byte) {
    disturb->byte = read_integer(*byte, 0, 9, problems).value_or(0);
  }
  return disturb;
}

std::optional<Action> delay(const YAML::Node& value, Table& fault, Problems& problems) {
  const auto byte = fault.need("byte");
  const auto by = fault.need("by");
  auto disturb = read_disturbance(Disturb::Way::late_byte, value, fault, problems);
  if (!disturb || !byte || !by) {
    return std::nullopt;
  }
  if (disturb->sender == Sender::spm) {
    problems.add(value, "the power module's bytes come when it sends them: SR or SACU");
    return std::nullopt;
  }
  disturb->byte = read_integer(*byte, 0, 9, problems).value_or(0);
  disturb->by = read_time(*by, problems).value_or(Time{});
  return disturb;
}

// {for: 200ms}
std::optional<Time> read_span(const YAML::Node& value, const std::string& what, Problems& problems) {
  Table map(value, what, problems);
  const auto span = map.need("for");
  map.done();
  return span ? read_time(*span, problems) : std::nullopt;
}

// {for: 200ms, share: 50%}
std::optional<Action> babble(const YAML::Node& value, Table&, Problems& problems) {
  Table map(value, "babble", problems);
  const auto span = map.need("for");
  const auto share = map.find("share");
  map.done();
  const auto time = span ? read_time(*span, problems) : std::nullopt;
  const auto part = share ? read_quantity(*share, Measure::share, problems) : std::optional(1.0);
  if (part && (*part < 0.01 || *part > 1)) {
    problems.add(*share, "the share of the time is 1% to 100%");
    return std::nullopt;
  }
  return time && part ? std::optional<Action>(Babble{*time, *part}) : std::nullopt;
}

std::optional<Action> jam(const YAML::Node& value, Table&, Problems& problems) {
  const auto time = read_span(value, "jam", problems);
  return time ? std::optional<Action>(Jam{*time}) : std::nullopt;
}

std::optional<Action> wake_pulse(const YAML::Node& value, Table&, Problems& problems) {
  const auto time = read_span(value, "wake pulse", problems);
  return time ? std::optional<Action>(WakePulse{*time}) : std::nullopt;
}

constexpr int first_ram_byte = 0x100;  // of the ATmega1284P
constexpr int last_ram_byte = 0x40FF;
constexpr int last_checked_byte = 0x94FF;  // of the flash

std::optional<Action> flip_flash(const YAML::Node& value, Table& fault, Problems& problems) {
  const auto bit = fault.need("bit");
  const auto address = read_integer(value, 0, last_checked_byte, problems);
  if (!address || !bit) {
    return std::nullopt;
  }
  Upset upset;
  upset.address = static_cast<std::uint32_t>(*address);
  upset.bit = read_integer(*bit, 0, 7, problems).value_or(0);
  return SpoilMemory{upset};
}

std::optional<Action> stick_ram(const YAML::Node& value, Table& fault, Problems& problems) {
  const auto bit = fault.need("bit");
  const auto level = fault.need("level");
  const auto address = read_integer(value, first_ram_byte, last_ram_byte, problems);
  if (!address || !bit || !level) {
    return std::nullopt;
  }
  Upset upset;
  upset.memory = Upset::Memory::ram;
  upset.address = static_cast<std::uint32_t>(*address);
  upset.bit = read_integer(*bit, 0, 7, problems).value_or(0);
  upset.is_stuck_high = read_choice(*level, {"low", "high"}, problems).value_or("low") == "high";
  return SpoilMemory{upset};
}

std::optional<Action> parse_known(const Pair& pair, Table& fault, Problems& problems) {
  for (const FaultWord& row : fault_words()) {
    if (row.word == pair.key) {
      return row.parse(pair.value, fault, problems);
    }
  }
  for (const DamageWord& row : damage_words()) {
    if (row.word == pair.key) {
      return row.parse(pair.value, true, problems);
    }
  }
  return std::nullopt;
}

}  // namespace

const std::vector<FaultWord>& fault_words() {
  static const std::vector<FaultWord> words{
      {"cut cable", "fault: cut cable", "nothing passes between remote and power module until 'restore: cable'", cut},
      {"corrupt checksum", "fault: {corrupt checksum: SR general, count: 3}",
       "the checksums of the next packets of that kind are wrong", corrupt},
      {"flip bit", "fault: {flip bit: SR general, byte: 4, bit: 3, count: 1}",
       "one bit of one byte (0 = start byte) of the next packets of that kind", flip},
      {"drop", "fault: {drop: SR TF, count: 1}", "one byte (byte: 0, if not said) of the next packets of that kind",
       drop},
      {"framing error", "fault: {framing error: SR general, byte: 3}",
       "the first stop bit of one byte (byte: 0, if not said) of the next packets of that kind is dominant",
       break_stop_bit},
      {"late byte", "fault: {late byte: SR general, byte: 3, by: 2.6ms}",
       "one byte of the next packets of that kind comes later, and with it the rest of the turn", delay},
      {"babble", "fault: {babble: {for: 200ms, share: 50%}}",
       "random characters from the scenario's seed, back to back if no share is said; the step does not wait", babble},
      {"jam", "fault: {jam: {for: 200ms}}",
       "a transmitter hangs: zeros without a stop bit, back to back; the step does not wait", jam},
      {"wake pulse", "fault: {wake pulse: {for: 200ms}}",
       "SBH above 12 V, nothing can be heard; the step does not wait", wake_pulse},
      {"flash bit", "fault: {flash bit: 38000, bit: 3}",
       "one bit of the power module's program flips, in the chip; the same again flips it back", flip_flash},
      {"stuck RAM bit", "fault: {stuck RAM bit: 9000, bit: 3, level: high}",
       "one bit of the power module's RAM (256 to 16639) cannot be changed any more, in the chip", stick_ram},
  };
  return words;
}

std::optional<Action> parse_fault(const YAML::Node& node, Problems& problems) {
  std::vector<std::string> known;
  for (const FaultWord& row : fault_words()) {
    known.push_back(row.word);
  }
  for (const DamageWord& row : damage_words()) {
    known.push_back(row.word);
  }
  if (node.IsScalar()) {
    if (node.Scalar() == "cut cable") {
      return CutCable{};
    }
    problems.add(node, fmt::format("unknown fault '{}'{}", node.Scalar(), suggest(node.Scalar(), known)));
    return std::nullopt;
  }
  const auto pairs = read_pairs(node, "fault", problems);
  if (pairs.empty()) {
    return std::nullopt;
  }
  const Pair& first = pairs.front();
  if (std::find(known.begin(), known.end(), first.key) == known.end()) {
    problems.add(first.key_node, fmt::format("unknown fault '{}'{}", first.key, suggest(first.key, known)));
    return std::nullopt;
  }
  Table fault(node, fmt::format("fault '{}'", first.key), problems);
  fault.find(first.key);
  auto action = parse_known(first, fault, problems);
  fault.done();
  return action;
}

}  // namespace simulation::scenario
