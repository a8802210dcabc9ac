// Numbers with units as people write them: "60ms", "24.5V", "-60%". The unit is compulsory, no space before it.
#pragma once

#include <string>
#include <variant>

#include "simulation/time.hpp"

namespace simulation::scenario {

// What a number measures; each has a unit in which its value is kept.
enum class Measure {
  count,      // no unit
  time,       // s, ms, us; kept in seconds
  speed,      // m/s, km/h; kept in m/s
  length,     // m, cm, mm; kept in m
  angle,      // deg; kept in degrees
  turn_rate,  // deg/s; kept in degrees a second
  voltage,    // V; kept in V
  current,    // A; kept in A
  share,      // %; kept as a fraction of 1
};

// "a time such as 60ms"
std::string example_of(Measure measure);
// "60ms", "0.5m/s": for reports, in the unit that reads best.
std::string show(double value, Measure measure);

// The value, or what is wrong with the text in words that tell the remedy.
struct Complaint {
  std::string text;
};
std::variant<double, Complaint> parse_quantity(const std::string& text, Measure measure);

Time to_time(double span_in_seconds);

// "> 0.5m/s", "<= 3", "61.5ms" (equal). Negative numbers keep their sign.
struct Comparison {
  enum class Operator { equal, not_equal, less, at_most, more, at_least };
  Operator op = Operator::equal;
  double value = 0;

  bool holds(double seen) const;
};
std::variant<Comparison, Complaint> parse_comparison(const std::string& text, Measure measure);

}  // namespace simulation::scenario
