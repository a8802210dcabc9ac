#include "simulation/scenario/control_values.hpp"

#include <fmt/format.h>

#include <cmath>

namespace simulation::scenario {
namespace {

constexpr int neutral = 512;

}  // namespace

std::optional<int> read_axis(const YAML::Node& value, Problems& problems) {
  if (value.IsScalar() && value.Scalar() == "neutral") {
    return neutral;
  }
  const auto share = read_quantity(value, Measure::share, problems);
  if (!share) {
    return std::nullopt;
  }
  if (std::abs(*share) > 1) {
    problems.add(value, fmt::format("{} is out of range: -100% to 100%, or neutral", value.Scalar()));
    return std::nullopt;
  }
  return neutral + static_cast<int>(std::lround(*share * (*share > 0 ? full_reading - neutral : neutral)));
}

std::optional<int> read_pot(const YAML::Node& value, Problems& problems) {
  const auto share = read_quantity(value, Measure::share, problems);
  if (share && (*share < 0 || *share > 1)) {
    problems.add(value, fmt::format("{} is out of range: 0% to 100%", value.Scalar()));
    return std::nullopt;
  }
  return share ? std::optional(static_cast<int>(std::lround(*share * full_pot))) : std::nullopt;
}

}  // namespace simulation::scenario
