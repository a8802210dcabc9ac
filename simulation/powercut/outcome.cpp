#include "simulation/powercut/outcome.hpp"

#include <fmt/format.h>

namespace simulation::powercut {
namespace {

constexpr std::uint8_t bits = 8;
constexpr std::uint32_t values = 256;
constexpr int random_bytes = 3;

using Kind = Outcome::Kind;

std::uint8_t flipped(std::uint8_t value, std::uint8_t bit) {
  return static_cast<std::uint8_t>(value ^ 1U << bit);
}

}  // namespace

std::uint32_t Random::below(std::uint32_t limit) {
  state_ = state_ * 6364136223846793005U + 1442695040888963407U;
  return static_cast<std::uint32_t>((state_ >> 33) % limit);
}

std::uint8_t Outcome::left(const EepromWrite& write) const {
  switch (kind) {
    case Kind::old:
      return write.before;
    case Kind::erased:
      return 0xFF;
    case Kind::complete:
      return write.after;
    case Kind::bit_of_old:
      return flipped(write.before, value);
    case Kind::bit_of_new:
      return flipped(write.after, value);
    case Kind::random:
      break;
  }
  return value;
}

std::string Outcome::tell() const {
  switch (kind) {
    case Kind::old:
      return "the old byte";
    case Kind::erased:
      return "FF";
    case Kind::complete:
      return "the new byte";
    case Kind::bit_of_old:
      return fmt::format("the old byte with bit {} flipped", value);
    case Kind::bit_of_new:
      return fmt::format("the new byte with bit {} flipped", value);
    case Kind::random:
      break;
  }
  return fmt::format("{:02X}", value);
}

std::vector<Outcome> all_outcomes(Random& random) {
  std::vector<Outcome> outcomes{{Kind::old}, {Kind::erased}, {Kind::complete}};
  for (std::uint8_t bit = 0; bit < bits; ++bit) {
    outcomes.push_back({Kind::bit_of_old, bit});
    outcomes.push_back({Kind::bit_of_new, bit});
  }
  for (int i = 0; i < random_bytes; ++i) {
    outcomes.push_back({Kind::random, static_cast<std::uint8_t>(random.below(values))});
  }
  return outcomes;
}

std::vector<Outcome> some_outcomes(Random& random) {
  return {{Kind::old},
          {Kind::erased},
          {Kind::complete},
          {Kind::bit_of_old, static_cast<std::uint8_t>(random.below(bits))},
          {Kind::bit_of_new, static_cast<std::uint8_t>(random.below(bits))},
          {Kind::random, static_cast<std::uint8_t>(random.below(values))}};
}

}  // namespace simulation::powercut
