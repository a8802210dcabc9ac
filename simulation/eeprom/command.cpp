#include "simulation/eeprom/command.hpp"

#include <sstream>
#include <stdexcept>

#include "simulation/eeprom/events.hpp"
#include "simulation/eeprom/file.hpp"
#include "simulation/scenario/parse.hpp"
#include "simulation/scenario/session.hpp"

namespace simulation::eeprom {
namespace {

constexpr int unusable = 2;
constexpr int broken = 3;

int tell_after(const EventsOrder& order, std::ostream& out, std::ostream& err) {
  const scenario::Scenario scenario = scenario::load_scenario(order.scenario);
  scenario::Request request;
  request.board = order.on;
  request.image = order.image;
  std::ostringstream story;
  const scenario::Result result = scenario::play(scenario, request, story);
  if (result.verdict == scenario::Verdict::skipped || result.eeprom.size() != size) {
    err << result.report << '\n';
    return result.verdict == scenario::Verdict::skipped ? unusable : broken;
  }
  if (result.verdict != scenario::Verdict::passed) {
    err << result.report;  // the log is worth reading all the same
  }
  out << make_event_table(result.eeprom);
  return 0;
}

}  // namespace

int tell_events(const EventsOrder& order, std::ostream& out, std::ostream& err) {
  try {
    if (!order.scenario.empty()) {
      return tell_after(order, out, err);
    }
    if (order.file.empty()) {
      throw std::runtime_error(
          "name a file, or a scenario with --after; avrdude reads a chip's EEPROM with -U eeprom:r:eeprom.hex:i");
    }
    out << make_event_table(load_file(order.file));
    return 0;
  } catch (const std::exception& error) {
    err << error.what() << '\n';
    return unusable;
  }
}

}  // namespace simulation::eeprom
