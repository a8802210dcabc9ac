#include <catch2/catch.hpp>

#include "simulation/scenario/quantity.hpp"
#include "simulation/scenario/spelling.hpp"

namespace {

using namespace simulation::scenario;

double value_of(const std::string& text, Measure measure) {
  return std::get<double>(parse_quantity(text, measure));
}

std::string complaint_of(const std::string& text, Measure measure) {
  return std::get<Complaint>(parse_quantity(text, measure)).text;
}

}  // namespace

TEST_CASE("numbers carry their units") {
  CHECK(value_of("60ms", Measure::time) == Approx(0.06));
  CHECK(value_of("1.5s", Measure::time) == Approx(1.5));
  CHECK(value_of("250us", Measure::time) == Approx(250e-6));
  CHECK(value_of("-3deg", Measure::angle) == Approx(-3));
  CHECK(value_of("24.5V", Measure::voltage) == Approx(24.5));
  CHECK(value_of("+60%", Measure::share) == Approx(0.6));
  CHECK(value_of("3.6km/h", Measure::speed) == Approx(1));
  CHECK(value_of("10cm", Measure::length) == Approx(0.1));
}

TEST_CASE("a missing or a wrong unit is told with the remedy") {
  CHECK(complaint_of("60", Measure::time) == "60 has no unit: write 60ms");
  CHECK(complaint_of("60V", Measure::time) ==
        "'V' is not a unit that fits here: expected a time such as 60ms, 1.5s or 250us");
  CHECK(complaint_of("soon", Measure::time) == "'soon' is not a time such as 60ms, 1.5s or 250us");
  CHECK(complaint_of("3ms", Measure::count) == "'3ms' must be a number without a unit");
  CHECK(complaint_of("", Measure::time) == "'' is not a time such as 60ms, 1.5s or 250us");
}

TEST_CASE("comparisons compare") {
  const auto more = std::get<Comparison>(parse_comparison("> 0.5m/s", Measure::speed));
  CHECK(more.holds(0.51));
  CHECK_FALSE(more.holds(0.5));
  const auto at_most = std::get<Comparison>(parse_comparison("<=41%", Measure::share));
  CHECK(at_most.holds(0.41));
  CHECK_FALSE(at_most.holds(0.411));
  const auto equal = std::get<Comparison>(parse_comparison("-3", Measure::count));
  CHECK(equal.holds(-3));
  CHECK_FALSE(equal.holds(3));
  CHECK(std::holds_alternative<Complaint>(parse_comparison("> 100", Measure::time)));
}

TEST_CASE("a slip of the pen is recognised") {
  CHECK(edit_distance("expect", "expcet") == 1);
  CHECK(edit_distance("wait", "say") == 3);
  CHECK(suggest("expcet", {"wait", "expect", "hold"}) == " (did you mean 'expect'?)");
  CHECK(suggest("frobnicate", {"wait", "hold"}) == " (known: wait, hold)");
}
