// What a byte may become whose write was cut.
#include "simulation/powercut/outcome.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace simulation::powercut {

TEST_CASE("a cut byte becomes the old one, FF, the new one, each of both with any one bit flipped, or anything",
          "[H-20]") {
  Random random(1);
  std::vector<int> left;
  for (const Outcome& outcome : all_outcomes(random)) {
    left.push_back(outcome.left({100, 0x3C, 0xA5}));
  }
  REQUIRE(left.size() == 22);
  for (const int wanted : {0x3C, 0xFF, 0xA5, 0x3D, 0x3E, 0x38, 0x34, 0x2C, 0x1C, 0x7C, 0xBC, 0xA4, 0xA7, 0xA1, 0xAD,
                           0xB5, 0x85, 0xE5, 0x25}) {
    CAPTURE(wanted);
    CHECK(std::count(left.begin(), left.end(), wanted) >= 1);
  }
}

TEST_CASE("the same seed draws the same, another one something else") {
  const auto drawn = [](std::uint64_t seed) {
    Random random(seed);
    std::vector<std::uint32_t> numbers;
    for (int i = 0; i < 20; ++i) {
      numbers.push_back(random.below(256));
    }
    return numbers;
  };
  CHECK(drawn(1) == drawn(1));
  CHECK(drawn(1) != drawn(2));
}

TEST_CASE("an outcome is told in words") {
  CHECK(Outcome{Outcome::Kind::erased}.tell() == "FF");
  CHECK(Outcome{Outcome::Kind::bit_of_new, 3}.tell() == "the new byte with bit 3 flipped");
  CHECK(Outcome{Outcome::Kind::random, 0x0A}.tell() == "0A");
}

}  // namespace simulation::powercut
