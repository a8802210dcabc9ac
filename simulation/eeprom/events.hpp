// The event log in words, which are the product's (spm/events_list.inc).
#pragma once

#include <string>
#include <vector>

#include "simulation/eeprom/layout.hpp"

namespace simulation::eeprom {

// "the remote fell silent"; "event 77, unknown to this version".
std::string tell_event(int code);
// "after a watchdog reset", "12 ms"; empty if the event has no argument.
std::string tell_argument(int code, int argument);
// Whether this argument of this event is one of several words, such as the four causes of a start.
bool has_words(int code, int argument);
// "started, after a watchdog reset"
std::string tell(const Record& record);

// Every event that this version knows, by code, for a choice of words.
std::vector<int> known_events();

// The whole log as a table, oldest first, with a line for an empty one.
std::string make_event_table(const Bytes& eeprom);

}  // namespace simulation::eeprom
