// How long the event log lasts, from its size and from what a cell stands.
#pragma once

#include <cstddef>

namespace simulation::powercut {

constexpr double cell_endurance = 100'000;  // writes, ATmega1284P data sheet

struct Usage {
  double power_cycles = 5;            // a day
  double records_of_power_cycle = 3;  // started, power-down asked for, powered down
  double events = 10;                 // a day, beside those
};

// Until the busiest cell of the ring is worn out. `writes_of_record` is how often a record writes its busiest cell.
constexpr double years_of_log(const Usage& usage, std::size_t places, double writes_of_record) {
  constexpr double days_of_year = 365.25;
  const double records = static_cast<double>(places) * cell_endurance / writes_of_record;
  return records / (usage.power_cycles * usage.records_of_power_cycle + usage.events) / days_of_year;
}

}  // namespace simulation::powercut
