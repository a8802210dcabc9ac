#include "drivers/base/bits.hpp"

#include <catch2/catch.hpp>

namespace {

using base::Field;

TEST_CASE("a field reads its own bits and no others", "[SB-2.4]") {
  const std::uint8_t data[2] = {0x00, 0xFF ^ 0x18};
  CHECK(base::read(data, Field{1, 4, 3}) == 0);
  CHECK(base::read(data, Field{1, 6, 5}) == 3);
  CHECK(base::read(data, Field{1, 2, 0}) == 7);
  CHECK(base::read(data, Field{1, 6, 0}) == 0x67);  // the marker in bit 7 never counts
  CHECK(base::read(data, Field{0, 6, 0}) == 0);
}

TEST_CASE("every field of a byte can be written, read back and leaves the rest alone") {
  for (std::uint8_t low = 0; low <= 6; ++low) {
    for (std::uint8_t high = low; high <= 6; ++high) {
      const Field field{0, high, low};
      for (unsigned value = 0; value < 1U << (high - low + 1); ++value) {
        std::uint8_t data[1] = {0};
        base::put(data, field, static_cast<std::uint8_t>(value));
        CAPTURE(int(high), int(low), value);
        REQUIRE(data[0] == value << low);
        REQUIRE(base::read(data, field) == value);
        REQUIRE(base::is_set(data, field) == (value != 0));
      }
    }
  }
}

TEST_CASE("a value too large for its field is cut, so that its neighbours stay what they are") {
  std::uint8_t data[1] = {0x41};
  base::put(data, Field{0, 4, 2}, std::uint8_t{0xFF});
  CHECK(data[0] == (0x41 | 0x1C));
}

TEST_CASE("a field knows the largest value it can hold") {
  CHECK(Field{0, 6, 0}.maximum() == 127);
  CHECK(Field{0, 4, 0}.maximum() == 31);
  CHECK(Field{0, 5, 5}.maximum() == 1);
}

}  // namespace
