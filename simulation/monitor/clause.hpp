// One thing that must always be true of the power module, seen from outside. The whole table is the monitor; it stands
// in clauses_*.cpp, a row for each clause.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/monitor/scene.hpp"

namespace simulation::monitor {

// When a clause is asked.
enum class Moment : std::uint8_t {
  millisecond,  // at each sample of the pins
  character,    // at each one the power module says
  turn,         // at the first of those
  packet,       // when it has said one whole
  general,      // the same, for general information
};

struct Clause {
  const char* id;          // "H-04.1": the first clause about hazard H-04
  const char* says;        // what holds
  const char* tolerance;   // and how exactly that is judged
  const char* stands_for;  // clauses of the requirements
  Moment moment;
  bool (*is_broken)(const Scene& scene);
};

// All of them, in the order of their ids.
const std::vector<Clause>& clauses();
const Clause* find_clause(const std::string& id);
// The table for people.
std::string tell_clauses();

// The parts of the table.
std::vector<Clause> motion_clauses();
std::vector<Clause> brake_clauses();
std::vector<Clause> report_clauses();
std::vector<Clause> power_clauses();
std::vector<Clause> bus_clauses();

}  // namespace simulation::monitor
