// `pilotfish events`: the event log in words, of a file or of what a scenario leaves behind.
#pragma once

#include <ostream>
#include <string>

namespace simulation::eeprom {

struct EventsOrder {
  std::string file;
  std::string scenario;  // instead of a file
  std::string on = "avr";
  std::string image;
};

// Exit code: 0, or 2 if file, scenario or image cannot be used, 3 if the simulation failed.
int tell_events(const EventsOrder& order, std::ostream& out, std::ostream& err);

}  // namespace simulation::eeprom
