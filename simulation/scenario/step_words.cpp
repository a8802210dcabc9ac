#include "simulation/scenario/step_words.hpp"

#include <fmt/format.h>

#include "simulation/scenario/parse_condition.hpp"

namespace simulation::scenario {
namespace {

using Parsed = std::optional<Action>;

// SB-1.2
constexpr Time wake_pulse = 300ms;

template <typename Made, typename Value>
Parsed made_of(const std::optional<Value>& value) {
  return value ? Parsed(Made{*value}) : std::nullopt;
}

Parsed parse_say(const YAML::Node& value, Table&, Problems& problems) {
  return made_of<Say>(read_text(value, problems));
}

Parsed parse_note(const YAML::Node& value, Table&, Problems& problems) {
  return made_of<Note>(read_text(value, problems));
}

Parsed parse_wait(const YAML::Node& value, Table&, Problems& problems) {
  if (value.IsScalar() && value.Scalar() == "mid-cycle") {
    return WaitForMidCycle{};
  }
  return made_of<Wait>(read_time(value, problems));
}

Parsed parse_press(const YAML::Node& value, Table&, Problems& problems) {
  if (value.IsNull()) {
    return PressPower{wake_pulse};
  }
  Table map(value, "press power", problems);
  const auto span = map.need("for");
  map.done();
  return span ? made_of<PressPower>(read_time(*span, problems)) : std::nullopt;
}

Parsed parse_sr(const YAML::Node& value, Table&, Problems& problems) {
  const auto controls = parse_controls(value, problems);
  return controls ? Parsed(*controls) : std::nullopt;
}

Parsed parse_remote_step(const YAML::Node& value, Table&, Problems& problems) {
  return parse_remote(value, problems);
}

Parsed parse_sacu_step(const YAML::Node& value, Table&, Problems& problems) {
  return parse_sacu(value, problems);
}

Parsed parse_programmer(const YAML::Node& value, Table&, Problems& problems) {
  if (value.IsScalar()) {
    return read_choice(value, {"clears"}, problems) ? Parsed(UseProgrammer{"", true}) : std::nullopt;
  }
  Table map(value, "programmer", problems);
  const auto types = map.need("types");
  map.done();
  const auto text = types ? read_characters(*types, problems) : std::nullopt;
  return text ? Parsed(UseProgrammer{*text}) : std::nullopt;
}

Parsed parse_expect(const YAML::Node& value, Table& step, Problems& problems) {
  Expect expect{parse_conditions(value, problems), default_deadline};
  if (const auto within = step.find("within")) {
    expect.within = read_time(*within, problems).value_or(default_deadline);
  }
  return expect;
}

Parsed parse_hold(const YAML::Node& value, Table& step, Problems& problems) {
  Hold hold{parse_conditions(value, problems), {}};
  if (const auto span = step.need("for")) {
    hold.span = read_time(*span, problems).value_or(Time{});
  }
  return hold;
}

Parsed parse_never(const YAML::Node& value, Table&, Problems& problems) {
  return Never{parse_conditions(value, problems)};
}

Parsed parse_send(const YAML::Node& value, Table&, Problems& problems) {
  Send send;
  Table map(value, "send", problems);
  if (const auto as = map.find("as")) {
    const auto word = read_choice(*as, {"SR", "SACU", "tester", "noise"}, problems);
    send.as = word == "SACU"     ? Sender::sacu
              : word == "tester" ? Sender::tester
              : word == "noise"  ? Sender::noise
                                 : Sender::sr;
  }
  if (const auto bytes = map.need("bytes")) {
    send.bytes = read_bytes(*bytes, problems).value_or(std::vector<std::uint8_t>{});
  }
  const auto every = map.find("every");
  const auto times = map.find("times");
  const auto span = map.find("for");
  map.done();
  send.every = every ? read_time(*every, problems).value_or(20ms) : Time{};
  if (every && send.every < 1ms) {
    problems.add(*every, "'every' must be at least 1ms");
    return std::nullopt;
  }
  if ((times || span) && !every) {
    problems.add(value, "'times' and 'for' need 'every', as in every: 20ms");
    return std::nullopt;
  }
  if (times && span) {
    problems.add(*span, "say 'times' or 'for', not both");
  } else if (times) {
    send.times = read_integer(*times, 1, 1000000, problems).value_or(1);
  } else if (span) {
    send.times = static_cast<int>(read_time(*span, problems).value_or(Time{}) / send.every);
  } else if (!every) {
    send.times = 1;
  }
  return send;
}

Parsed parse_stop(const YAML::Node&, Table&, Problems&) {
  return StopSending{};
}

Parsed parse_fault_step(const YAML::Node& value, Table&, Problems& problems) {
  return parse_fault(value, problems);
}

Parsed parse_restore_step(const YAML::Node& value, Table&, Problems& problems) {
  return parse_restore(value, problems);
}

Parsed parse_slope(const YAML::Node& value, Table&, Problems& problems) {
  return made_of<Slope>(read_quantity(value, Measure::angle, problems));
}

Parsed parse_dci(const YAML::Node& value, Table&, Problems& problems) {
  return made_of<Dci>(read_switch(value, problems));
}

Parsed parse_battery(const YAML::Node& value, Table&, Problems& problems) {
  return made_of<Battery>(read_quantity(value, Measure::voltage, problems));
}

Parsed parse_reset(const YAML::Node& value, Table&, Problems& problems) {
  const auto word = read_choice(value, {"watchdog", "brown-out", "external"}, problems);
  if (!word) {
    return std::nullopt;
  }
  return *word == "watchdog" ? Reset::watchdog : *word == "brown-out" ? Reset::brown_out : Reset::external;
}

}  // namespace

const std::vector<StepWord>& step_words() {
  static const std::vector<StepWord> words{
      {"say", "say: the cable is cut", "a heading of the story", parse_say},
      {"note", "note: the remote repeats itself until answered", "a remark in the log", parse_note},
      {"wake", "wake", "the power button wakes the power module: 300 ms pulse, button down meanwhile", parse_press},
      {"press power", "press power: {for: 300ms}",
       "the power button goes down and up; wakes the power module if it sleeps. The step lasts as long", parse_press},
      {"sr", "sr: {speed: 60%, pot: 100%}", "hands on the remote; see the list below", parse_sr},
      {"remote", "remote: {period: 66ms}", "the remote itself: silent or talks, or see the list below",
       parse_remote_step},
      {"sacu", "sacu: {attendant: on, speed: 40%}",
       "an attendant control: attached or detached (as it is at first), or see the list below", parse_sacu_step},
      {"programmer", "programmer: {types: \"hello\\r\"}",
       "the programmer behind the remote: types characters (0x80 to 0x83 as \"\\x80\"), or clears its screen; the step "
       "does not wait",
       parse_programmer},
      {"wait", "wait: 60ms", "lets time pass; 'wait: mid-cycle' until 12 ms after the begin of the remote's turn",
       parse_wait},
      {"expect", "expect: {motors: stopped, brakes: engaged}\n  within: 300ms",
       "all of it true at one moment before the deadline (100ms if not said); the step always lasts to the deadline",
       parse_expect},
      {"hold", "hold: {chair: still}\n  for: 500ms", "all of it true the whole time", parse_hold},
      {"never", "never: {answer delay: \"> 100us\"}", "not all of it true at one moment for the rest of the run",
       parse_never},
      {"send", "send: {as: SR, bytes: \"60 C0 C0 FF CD 80 84 80 C5 0F\", every: 20ms, for: 2s}",
       "bytes on the wire, as SR, SACU, tester (a factory's) or noise, once, some times, or with 'every' alone in the "
       "background",
       parse_send},
      {"stop sending", "stop sending", "ends a 'send' in the background", parse_stop},
      {"fault", "fault: {corrupt checksum: SR general, count: 3}",
       "disturbs the wire or breaks a part of the chair; see the list below", parse_fault_step},
      {"restore", "restore: {stuck bridge: right}",
       "mends a broken part of the chair, named as in 'fault'; 'restore: cable' ends 'cut cable'", parse_restore_step},
      {"slope", "slope: 6deg", "the ground rises (falls: negative) ahead of the chair", parse_slope},
      {"dci", "dci: on", "the input by which a seat or a lift asks for slow", parse_dci},
      {"battery", "battery: 22V", "open-circuit voltage of the batteries", parse_battery},
      {"reset", "reset: watchdog", "resets the chip: watchdog, brown-out or external", parse_reset},
  };
  return words;
}

}  // namespace simulation::scenario
