#include "simulation/eeprom/events.hpp"

#include <fmt/format.h>

#include <sstream>

#include "spm/words.hpp"

namespace simulation::eeprom {
namespace {

constexpr int last_code = 255;
constexpr unsigned most_seconds = 65535;

// "a|b|c": the one at `place`; empty beyond.
std::string choice_of(const std::string& choices, int place) {
  std::istringstream stream(choices);
  std::string choice;
  for (int i = 0; i <= place; ++i) {
    if (!std::getline(stream, choice, '|')) {
      return "";
    }
  }
  return choice;
}

std::string tell_seconds(unsigned seconds) {
  return seconds == most_seconds ? "65535 s or more" : fmt::format("{} s", seconds);
}

}  // namespace

std::string tell_event(int code) {
  const char* words = spm::words_of_event(static_cast<std::uint8_t>(code));
  return words != nullptr ? words : fmt::format("event {}, unknown to this version", code);
}

std::string tell_argument(int code, int argument) {
  const char* words = spm::words_of_argument(static_cast<std::uint8_t>(code));
  const std::string meaning = words != nullptr ? words : "argument #";
  if (meaning.empty()) {
    return argument == 0 ? "" : fmt::format("argument {}", argument);
  }
  if (const auto mark = meaning.find('#'); mark != std::string::npos) {
    return meaning.substr(0, mark) + std::to_string(argument) + meaning.substr(mark + 1);
  }
  const std::string choice = choice_of(meaning, argument);
  return choice.empty() ? fmt::format("argument {}", argument) : choice;
}

bool has_words(int code, int argument) {
  const char* words = spm::words_of_argument(static_cast<std::uint8_t>(code));
  const std::string meaning = words != nullptr ? words : "";
  return meaning.find('|') != std::string::npos && !choice_of(meaning, argument).empty();
}

std::string tell(const Record& record) {
  const std::string argument = tell_argument(record.code, record.argument);
  return tell_event(record.code) + (argument.empty() ? "" : ", " + argument);
}

std::vector<int> known_events() {
  std::vector<int> codes;
  for (int code = 1; code <= last_code; ++code) {
    if (spm::words_of_event(static_cast<std::uint8_t>(code)) != nullptr) {
      codes.push_back(code);
    }
  }
  return codes;
}

std::string make_event_table(const Bytes& eeprom) {
  const std::vector<Record> records = read_log(eeprom);
  if (records.empty()) {
    return "the event log is empty\n";
  }
  std::string text = fmt::format("{:>7}  {:>8}  {:>16}   {}\n", "number", "start", "seconds after it", "what happened");
  for (const Record& record : records) {
    text += fmt::format("{:>7}  {:>8}  {:>16}   {}\n", record.sequence, record.starts, tell_seconds(record.seconds),
                        tell(record));
  }
  return text + fmt::format("{} of {} places used\n", records.size(), places);
}

}  // namespace simulation::eeprom
