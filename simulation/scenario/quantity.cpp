#include "simulation/scenario/quantity.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace simulation::scenario {
namespace {

struct Unit {
  Measure measure;
  std::string_view word;
  double factor;
};

// The first unit of a measure is the one that complaints suggest.
constexpr std::array units{
    Unit{Measure::time, "ms", 1e-3},      Unit{Measure::time, "us", 1e-6},       Unit{Measure::time, "s", 1},
    Unit{Measure::speed, "m/s", 1},       Unit{Measure::speed, "km/h", 1 / 3.6}, Unit{Measure::length, "cm", 1e-2},
    Unit{Measure::length, "mm", 1e-3},    Unit{Measure::length, "m", 1},         Unit{Measure::angle, "deg", 1},
    Unit{Measure::turn_rate, "deg/s", 1}, Unit{Measure::voltage, "V", 1},        Unit{Measure::current, "A", 1},
    Unit{Measure::share, "%", 1e-2},      Unit{Measure::count, "", 1},
};

const Unit& first_unit(Measure measure) {
  for (const Unit& unit : units) {
    if (unit.measure == measure) {
      return unit;
    }
  }
  return units.back();
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') {
    text.remove_prefix(1);
  }
  while (!text.empty() && text.back() == ' ') {
    text.remove_suffix(1);
  }
  return text;
}

const Unit* find_unit(std::string_view word, Measure measure) {
  for (const Unit& unit : units) {
    if (unit.measure == measure && unit.word == word) {
      return &unit;
    }
  }
  return nullptr;
}

Complaint complain_about_unit(std::string_view number, std::string_view word, Measure measure) {
  if (measure == Measure::count) {
    return {fmt::format("'{}{}' must be a number without a unit", number, word)};
  }
  if (word.empty()) {
    return {fmt::format("{} has no unit: write {}{}", number, number, first_unit(measure).word)};
  }
  return {fmt::format("'{}' is not a unit that fits here: expected {}", word, example_of(measure))};
}

}  // namespace

std::string example_of(Measure measure) {
  switch (measure) {
    case Measure::count:
      return "a number such as 3";
    case Measure::time:
      return "a time such as 60ms, 1.5s or 250us";
    case Measure::speed:
      return "a speed such as 0.5m/s or 2km/h";
    case Measure::length:
      return "a length such as 10cm, 5mm or 1.2m";
    case Measure::angle:
      return "an angle such as 6deg";
    case Measure::turn_rate:
      return "a turn rate such as 20deg/s";
    case Measure::voltage:
      return "a voltage such as 24.5V";
    case Measure::current:
      return "a current such as 12A";
    case Measure::share:
      break;
  }
  return "a share such as 60%";
}

std::string show(double value, Measure measure) {
  switch (measure) {
    case Measure::time:
      return std::abs(value) >= 1      ? fmt::format("{:.4g}s", value)
             : std::abs(value) >= 1e-3 ? fmt::format("{:.4g}ms", value * 1e3)
                                       : fmt::format("{:.4g}us", value * 1e6);
    case Measure::length:
      return std::abs(value) >= 1 ? fmt::format("{:.3g}m", value) : fmt::format("{:.3g}cm", value * 1e2);
    case Measure::share:
      return fmt::format("{:.3g}%", value * 1e2);
    default:
      return fmt::format("{:.3g}{}", value, first_unit(measure).word);
  }
}

std::variant<double, Complaint> parse_quantity(const std::string& text, Measure measure) {
  const std::string_view whole = trim(text);
  const std::string_view digits = whole.starts_with('+') ? whole.substr(1) : whole;
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || !std::isfinite(number)) {
    return Complaint{fmt::format("'{}' is not {}", whole, example_of(measure))};
  }
  const std::string_view word = whole.substr(static_cast<std::size_t>(end - whole.data()));
  const Unit* unit = find_unit(trim(word), measure);
  if (unit == nullptr) {
    return complain_about_unit(whole.substr(0, whole.size() - word.size()), trim(word), measure);
  }
  return number * unit->factor;
}

Time to_time(double span_in_seconds) {
  return Time(std::llround(span_in_seconds * 1e9));
}

bool Comparison::holds(double seen) const {
  constexpr double rounding = 1e-9;
  switch (op) {
    case Operator::equal:
      return std::abs(seen - value) <= rounding;
    case Operator::not_equal:
      return std::abs(seen - value) > rounding;
    case Operator::less:
      return seen < value;
    case Operator::at_most:
      return seen <= value + rounding;
    case Operator::more:
      return seen > value;
    case Operator::at_least:
      return seen >= value - rounding;
  }
  return false;
}

std::variant<Comparison, Complaint> parse_comparison(const std::string& text, Measure measure) {
  using Operator = Comparison::Operator;
  struct Sign {
    std::string_view word;
    Operator op;
  };
  constexpr std::array signs{Sign{"<=", Operator::at_most},   Sign{">=", Operator::at_least},
                             Sign{"!=", Operator::not_equal}, Sign{"==", Operator::equal},
                             Sign{"<", Operator::less},       Sign{">", Operator::more},
                             Sign{"=", Operator::equal}};
  std::string_view rest = trim(text);
  Comparison comparison;
  for (const Sign& sign : signs) {
    if (rest.starts_with(sign.word)) {
      comparison.op = sign.op;
      rest.remove_prefix(sign.word.size());
      break;
    }
  }
  const auto value = parse_quantity(std::string(rest), measure);
  if (const auto* complaint = std::get_if<Complaint>(&value)) {
    return *complaint;
  }
  comparison.value = std::get<double>(value);
  return comparison;
}

}  // namespace simulation::scenario
