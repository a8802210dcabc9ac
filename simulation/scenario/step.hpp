// A scenario as plain values: what was read from the file, before anything runs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/bus_event.hpp"
#include "simulation/models/chair.hpp"
#include "simulation/models/remote.hpp"
#include "simulation/models/sacu.hpp"
#include "simulation/scenario/condition.hpp"
#include "simulation/scenario/problem.hpp"
#include "simulation/time.hpp"

namespace simulation::scenario {

// `expect` without `within`.
constexpr Time default_deadline = 100ms;

struct Say {  // a heading of the story
  std::string text;
};
struct Note {  // a remark in the log
  std::string text;
};
struct Wait {
  Time span{};
};
struct WaitForMidCycle {};  // to 12 ms after the begin of the remote's turn: the bus is quiet
struct PressPower {
  Time span{};
};
struct SetControls {
  std::vector<std::function<void(RemoteControls&)>> changes;
};
// Something about a module itself, with what the story says of it.
template <typename Module>
struct Habit {
  std::function<void(Module&)> change;
  std::string deed;
};
struct SetRemote {
  std::optional<bool> talks;
  std::optional<Time> period;
  std::vector<std::function<void(RemoteIdentity&)>> changes{};
  std::vector<Habit<Remote>> habits{};
};
struct SetSacu {
  std::optional<bool> is_attached;
  std::vector<std::function<void(SacuControls&)>> changes{};
  std::vector<Habit<Sacu>> habits{};
};
struct UseProgrammer {
  std::string types;  // in the programmer's own codes
  bool clears = false;
};

// Every step lasts as long as it says, whatever the power module does: `expect` its whole deadline, too. So
// the time line of a scenario is the same on every machine.
struct Expect {
  std::vector<Condition> conditions;  // all at one moment
  Time within = default_deadline;
};
struct Hold {
  std::vector<Condition> conditions;
  Time span{};
};
struct Never {
  std::vector<Condition> conditions;  // all at one moment is what must not be
};

struct Send {  // bytes as they are; needs a silent remote
  Sender as = Sender::sr;
  std::vector<std::uint8_t> bytes;
  Time every{};
  std::optional<int> times;  // without: in the background, until the next `send` or `stop sending`
};
struct StopSending {};

struct CutCable {};
struct MendCable {};
struct Disturb {  // of the next `count` packets of one kind
  enum class Way { corrupt_checksum, flip_bit, drop, framing_error, late_byte };
  Way way = Way::corrupt_checksum;
  Sender sender = Sender::sr;
  std::uint8_t start_nibble = 0;  // packet type; 0x0F is TF
  int byte = 0;                   // in the packet, 0 = start byte
  int bit = 0;
  int count = 1;
  Time by{};  // how late
};
struct Babble {  // random characters
  Time span{};
  double share = 1;  // of the time
};
struct Jam {  // zeros without a stop bit
  Time span{};
};
struct WakePulse {  // SBH above 12 V
  Time span{};
};

struct Break {  // a part of the chair, or mend it
  Damage damage = Damage::open_coil;
  Side side = Side::left;
  bool is_broken = true;
};

struct BreakLamp {
  LampDamage damage = LampDamage::open;
  LampPlace place = LampPlace::left_indicator;
  bool is_broken = true;
};
struct BreakActuator {
  ActuatorDamage damage = ActuatorDamage::open;
  int number = 1;
  bool is_broken = true;
};

struct SpoilMemory {  // of the power module's chip
  Upset upset;
};

struct Slope {
  double degrees = 0;
};
struct Dci {  // the input by which a seat or a lift asks for slow
  bool is_on = false;
};
struct Battery {
  double volts = 0;
};
enum class Reset { watchdog, brown_out, external };

using Action = std::variant<Say, Note, Wait, WaitForMidCycle, PressPower, SetControls, SetRemote, SetSacu,
                            UseProgrammer, Expect, Hold, Never, Send, StopSending, CutCable, MendCable, Disturb, Babble,
                            Jam, WakePulse, Break, BreakLamp, BreakActuator, SpoilMemory, Slope, Dci, Battery, Reset>;

struct Step {
  Mark mark;
  std::string text;  // "sr: {speed: 60%}", for people
  Action action;
};

// Clauses of the monitor that a scenario breaks on purpose.
struct Exceptions {
  std::vector<std::string> clauses;
  std::string because;
};

// The power module under test.
struct Module {
  bool is_there = true;
  bool has_lighting = true;          // the option strap
  std::vector<std::uint8_t> eeprom;  // at its first start; empty: erased
};

struct Scenario {
  std::string file;  // as named on the command line
  std::string name;
  std::string about;
  std::vector<std::string> spec;  // clause ids
  std::vector<std::string> tags;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> needs;  // boards that can judge it: avr, host; empty = all
  Exceptions exceptions;
  Module module;
  std::vector<Step> steps;  // what `given` stands for comes first
};

}  // namespace simulation::scenario
