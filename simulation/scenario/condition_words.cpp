// Every word a condition may use. The words about the SPM's report are the names of its general packet's
// fields, from the decode table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulation/eeprom/events.hpp"
#include "simulation/report/decode.hpp"
#include "simulation/scenario/condition.hpp"

namespace simulation::scenario {
namespace {

constexpr double standstill = 0.01;  // m/s
constexpr double no_turning = 1.0;   // degrees a second

using Test = std::function<bool(const Facts&, const Anchor&)>;

Test when(bool (*fact)(const Facts&)) {
  return [fact](const Facts& facts, const Anchor&) { return fact(facts); };
}

Choice either(const char* yes, const char* no, Test is_true) {
  return {{{yes, is_true}, {no, [is_true](const Facts& f, const Anchor& a) { return !is_true(f, a); }}}};
}

Choice yes_or_no(Test is_true) {
  return either("yes", "no", std::move(is_true));
}

Gauge gauge(Measure measure, double (*read)(const Facts&)) {
  return {measure, [read](const Facts& facts, const Anchor&) { return std::optional(read(facts)); }};
}

bool is_moving(const Facts& f) {
  return std::abs(f.speed()) > standstill || std::abs(f.turn_rate()) > no_turning;
}

std::optional<double> answer_delay(const Facts& facts, const Anchor&) {
  return facts.answer_delay() ? std::optional(seconds(*facts.answer_delay())) : std::nullopt;
}

void add_motion(std::vector<ConditionWord>& words) {
  words.push_back({"chair", "still", "how the chair moves",
                   Choice{{{"still", when([](const Facts& f) { return !is_moving(f); })},
                           {"moving", when(is_moving)},
                           {"moving forward", when([](const Facts& f) { return f.speed() > standstill; })},
                           {"moving backward", when([](const Facts& f) { return f.speed() < -standstill; })},
                           {"turning left", when([](const Facts& f) { return f.turn_rate() < -no_turning; })},
                           {"turning right", when([](const Facts& f) { return f.turn_rate() > no_turning; })}}}});
  words.push_back({"chair speed", "> 0.5m/s", "its speed over ground, forward or backward",
                   gauge(Measure::speed, [](const Facts& f) { return std::abs(f.speed()); })});
  words.push_back({"chair rolled", "< 30cm", "how far it is from where it was when the step began",
                   Gauge{Measure::length, [](const Facts& f, const Anchor& since) {
                           return std::optional(std::abs(f.position() - since.position));
                         }}});
  words.push_back({"motors", "stopped", "driving: a motor has voltage; steady: no motor got more than a moment ago",
                   Choice{{{"driving", when([](const Facts& f) { return f.is_driven(); })},
                           {"stopped", when([](const Facts& f) { return !f.is_driven(); })},
                           {"not speeding up", when([](const Facts& f) { return !f.has_sped_up(); })}}}});
  words.push_back({"duty", "<= 40%", "the larger share of the supply that a motor gets",
                   gauge(Measure::share, [](const Facts& f) { return f.largest_duty(); })});
  words.push_back(
      {"brakes", "engaged", "the park brakes; 'mixed' while one is released and the other is not",
       Choice{{{"engaged",
                when([](const Facts& f) { return !f.pins().left_brake_release && !f.pins().right_brake_release; })},
               {"released",
                when([](const Facts& f) { return f.pins().left_brake_release && f.pins().right_brake_release; })},
               {"mixed",
                when([](const Facts& f) { return f.pins().left_brake_release != f.pins().right_brake_release; })}}}});
}

bool is_an_actuator_on(const Facts& f) {
  return f.pins().actuator1_extend || f.pins().actuator1_retract || f.pins().actuator2_extend ||
         f.pins().actuator2_retract;
}

// Both at once is what must never be.
Choice direction_choice(bool Pins::*extend, bool Pins::*retract) {
  const auto are = [=](bool extends, bool retracts) -> Test {
    return [=](const Facts& f, const Anchor&) { return f.pins().*extend == extends && f.pins().*retract == retracts; };
  };
  return {{{"extending", are(true, false)},
           {"retracting", are(false, true)},
           {"off", are(false, false)},
           {"both ways", are(true, true)}}};
}

Choice pin_choice(bool Pins::*pin) {
  return either("on", "off", [pin](const Facts& f, const Anchor&) { return f.pins().*pin; });
}

Gauge chair_gauge(Measure measure, double ChairState::*value) {
  return {measure, [value](const Facts& f, const Anchor&) { return std::optional(f.chair().*value); }};
}

void add_loads(std::vector<ConditionWord>& words) {
  words.push_back(
      {"actuator 1", "extending", "its two pins", direction_choice(&Pins::actuator1_extend, &Pins::actuator1_retract)});
  words.push_back({"actuator 2", "retracting", "its two pins",
                   direction_choice(&Pins::actuator2_extend, &Pins::actuator2_retract)});
  words.push_back({"actuator 1 position", "> 60%", "where it is in its travel: 0% retracted, 100% extended",
                   chair_gauge(Measure::share, &ChairState::actuator1_position)});
  words.push_back({"actuator 2 position", "50%", "where it is in its travel: 0% retracted, 100% extended",
                   chair_gauge(Measure::share, &ChairState::actuator2_position)});
  words.push_back({"left indicator pin", "on", "the output of that lamp", pin_choice(&Pins::left_indicator)});
  words.push_back({"right indicator pin", "on", "the output of that lamp", pin_choice(&Pins::right_indicator)});
  words.push_back({"headlight pin", "off", "the output of that lamp", pin_choice(&Pins::headlight)});
  words.push_back({"left indicator current", "> 1A", "through that lamp",
                   chair_gauge(Measure::current, &ChairState::left_indicator_current)});
  words.push_back({"right indicator current", "> 1A", "through that lamp",
                   chair_gauge(Measure::current, &ChairState::right_indicator_current)});
  words.push_back(
      {"headlight current", "0A", "through that lamp", chair_gauge(Measure::current, &ChairState::headlight_current)});
}

void add_pins(std::vector<ConditionWord>& words) {
  words.push_back({"power latch", "held", "the pin that keeps the supply on",
                   either("held", "released", when([](const Facts& f) { return f.pins().power_latch; }))});
  words.push_back({"powered", "yes", "the power module has its supply",
                   yes_or_no(when([](const Facts& f) { return f.is_powered(); }))});
  words.push_back({"bridge", "disabled", "the gate drivers of the motor bridges",
                   either("enabled", "disabled", when([](const Facts& f) { return f.pins().bridge_enable; }))});
  words.push_back({"motor relay", "open", "the contactor before the bridges",
                   either("closed", "open", when([](const Facts& f) { return f.pins().motor_relay; }))});
  words.push_back({"actuators", "off", "the four pins that extend or retract an actuator",
                   either("on", "off", when(is_an_actuator_on))});
  words.push_back({"resets", "1", "resets of the power module since the step began, power-on not counted",
                   Gauge{Measure::count, [](const Facts& f, const Anchor& since) {
                           return std::optional<double>(f.resets() - since.resets);
                         }}});
}

Choice silence_of(Sender sender) {
  return yes_or_no([sender](const Facts& f, const Anchor& since) {
    return !f.last_byte_of(sender) || *f.last_byte_of(sender) < since.at;
  });
}

void add_talk(std::vector<ConditionWord>& words) {
  words.push_back({"answered", "yes", "the remote's last complete turn got an answer",
                   yes_or_no(when([](const Facts& f) { return f.was_answered(); }))});
  words.push_back(
      {"silent", "yes", "the power module has sent nothing since the step began",
       yes_or_no([](const Facts& f, const Anchor& since) { return !f.spoke_at() || *f.spoke_at() < since.at; })});
  words.push_back({"answer delay", "< 100us", "from the end of the remote's turn to the answer's first edge",
                   Gauge{Measure::time, answer_delay}});
  words.push_back({"SPM sends", "settings",
                   "a packet it has sent since the step began: general, power-up, settings, or bytes as \"05 83 F7\"",
                   Utterance{Sender::spm, {"general", "power-up", "settings"}}});
  words.push_back({"SR sends", "\"27 80 80 80 D8\"",
                   "a packet the remote has sent since the step began: general, power-up, or bytes",
                   Utterance{Sender::sr, {"general", "power-up"}}});
  words.push_back({"SACU sends", "general",
                   "a packet the attendant control has sent since the step began: general, power-up, or bytes",
                   Utterance{Sender::sacu, {"general", "power-up"}}});
  words.push_back({"SR silent", "yes", "the remote has sent nothing since the step began", silence_of(Sender::sr)});
  words.push_back(
      {"SACU silent", "yes", "the attendant control has sent nothing since the step began", silence_of(Sender::sacu)});
  words.push_back({"communications fault", "yes",
                   "the remote shows one: it has not understood a general of the power module for a second",
                   yes_or_no(when([](const Facts& f) { return f.shows_communication_fault(); }))});
  words.push_back({"programmer sees", "\"OK\\r\"", "its screen holds these characters, since it was cleared last",
                   Screen{[](const Facts& f) -> const std::string& { return f.programmer_screen(); }}});
  words.push_back(
      {"programmer characters", ">= 100", "how many its screen holds",
       gauge(Measure::count, [](const Facts& f) { return static_cast<double>(f.programmer_screen().size()); })});
}

// An event alone, and with each argument that has words.
using IsEvent = std::function<bool(const eeprom::Record&)>;
Choice event_choice(const std::function<Test(IsEvent)>& test_of) {
  constexpr int most_choices = 8;
  Choice choice;
  for (const int code : eeprom::known_events()) {
    choice.options.push_back({eeprom::tell_event(code), test_of([code](const auto& r) { return r.code == code; })});
    for (int argument = 0; argument < most_choices; ++argument) {
      if (!eeprom::has_words(code, argument)) {
        continue;
      }
      choice.options.push_back({eeprom::tell_event(code) + ", " + eeprom::tell_argument(code, argument),
                                test_of([=](const auto& r) { return r.code == code && r.argument == argument; })});
    }
  }
  return choice;
}

void add_memory(std::vector<ConditionWord>& words) {
  words.push_back({"last event", "the remote fell silent", "the newest in the event log, which outlives the supply",
                   event_choice([](IsEvent is_it) -> Test {
                     return [is_it](const Facts& facts, const Anchor&) {
                       const auto newest = eeprom::newest_record(facts.eeprom());
                       return newest && is_it(*newest);
                     };
                   })});
  words.push_back({"events include", "started", "any in the event log", event_choice([](IsEvent is_it) -> Test {
                     return [is_it](const Facts& facts, const Anchor&) {
                       const auto records = eeprom::read_log(facts.eeprom());
                       return std::any_of(records.begin(), records.end(), is_it);
                     };
                   })});
  words.push_back({"events", ">= 3", "how many the event log holds", gauge(Measure::count, [](const Facts& facts) {
                     return static_cast<double>(eeprom::read_log(facts.eeprom()).size());
                   })});
}

// Nothing yet means: neither yes nor no.
std::optional<int> reported(const Facts& facts, const report::FieldRow& field) {
  return facts.spm_general() ? std::optional(field.read(*facts.spm_general())) : std::nullopt;
}

Choice report_flag(const report::FieldRow& field) {
  const auto says = [&field](int wanted) {
    return [&field, wanted](const Facts& facts, const Anchor&) { return reported(facts, field) == wanted; };
  };
  return {{{"yes", says(1)}, {"no", says(0)}}};
}

Choice report_state(const report::FieldRow& field) {
  Choice choice;
  for (int state = 0; state < report::system_state_count; ++state) {
    const auto is_it = [&field, state](const Facts& facts, const Anchor&) { return reported(facts, field) == state; };
    choice.options.push_back({report::system_state_name(state), is_it});
    choice.options.push_back({fmt::format("{:02X}", state), is_it});
  }
  return choice;
}

ConditionWord report_word(const report::FieldRow& field) {
  const std::string meaning = "as the power module's last general packet says";
  switch (field.style) {
    case report::Style::flag:
      return {field.name, "yes", meaning, report_flag(field)};
    case report::Style::state:
      return {field.name, "Shark cable fault", meaning + "; a name or its number", report_state(field)};
    default:
      return {field.name, "> 5", meaning, Gauge{Measure::count, [&field](const Facts& facts, const Anchor&) {
                                                  const auto value = reported(facts, field);
                                                  return value ? std::optional<double>(*value) : std::nullopt;
                                                }}};
  }
}

std::vector<ConditionWord> all_words() {
  std::vector<ConditionWord> words;
  add_motion(words);
  add_pins(words);
  add_loads(words);
  add_talk(words);
  add_memory(words);
  for (const report::FieldRow& field : report::spm_general().fields) {
    words.push_back(report_word(field));
    if (words.back().word == "slowdown") {
      words.push_back(words.back());
      words.back().word = "limp";
      words.back().meaning = "the same bit as 'slowdown', which LIMP sets (SB-01.1)";
    }
  }
  return words;
}

}  // namespace

const std::vector<ConditionWord>& condition_words() {
  static const std::vector<ConditionWord> words = all_words();
  return words;
}

}  // namespace simulation::scenario
