#include "simulation/scenario/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace simulation::scenario {

// Longer lists of words help nobody in a message.
constexpr std::size_t readable = 24;

std::size_t edit_distance(const std::string& one, const std::string& other) {
  const std::size_t width = other.size() + 1;
  std::vector<std::size_t> table((one.size() + 1) * width);
  const auto at = [&](std::size_t row, std::size_t column) -> std::size_t& { return table[row * width + column]; };
  for (std::size_t i = 0; i <= one.size(); ++i) {
    for (std::size_t j = 0; j <= other.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const std::size_t change = one[i - 1] == other[j - 1] ? 0 : 1;
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1]) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return table.back();
}

std::string suggest(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& one, const auto& other) {
    return edit_distance(word, one) < edit_distance(word, other);
  });
  if (nearest == known.end()) {
    return "";
  }
  if (edit_distance(word, *nearest) <= std::max<std::size_t>({1, nearest->size() / 3, word.size() / 3})) {
    return fmt::format(" (did you mean '{}'?)", *nearest);
  }
  if (known.size() > readable) {
    return " (pilotfish list-steps tells all)";
  }
  return fmt::format(" (known: {})", fmt::join(known, ", "));
}

}  // namespace simulation::scenario
