#include "drivers/base/units.hpp"

#include <catch2/catch.hpp>
#include <type_traits>

#include "drivers/base/flash.hpp"

namespace {

using namespace base;

TEST_CASE("quantities of one kind add, subtract and compare") {
  CHECK(24000_mV + 500_mV == 24500_mV);
  CHECK(24000_mV - 500_mV == 23500_mV);
  CHECK(-(300_mA) == Milliamps(-300));
  CHECK(300_mA > Milliamps(-300));
  CHECK(Milliamps(-300) < 0_mA);
  CHECK(1000_permille >= 1000_permille);
  CHECK(999_permille <= 1000_permille);
  CHECK(999_permille != 1000_permille);
}

TEST_CASE("a magnitude forgets the sign") {
  CHECK(magnitude(0) == 0);
  CHECK(magnitude(16384) == 16384);
  CHECK(magnitude(-16384) == 16384);
  CHECK(magnitude(-32767) == 32767);
}

TEST_CASE("a quantity takes no more room than its number, and no bare number becomes one") {
  STATIC_REQUIRE(sizeof(Millivolts) == sizeof(std::uint16_t));
  STATIC_REQUIRE_FALSE(std::is_convertible_v<int, Millivolts>);
  STATIC_REQUIRE_FALSE(std::is_constructible_v<Millivolts, Permille>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<Millivolts, std::uint16_t>);
}

TEST_CASE("a row read from flash equals the row that was put there") {
  struct Row {
    std::uint8_t small;
    std::uint16_t large;
  };
  static const Row rows[2] IN_FLASH = {{1, 0x1234}, {2, 0xABCD}};
  const Row second = from_flash(rows[1]);
  CHECK(second.small == 2);
  CHECK(second.large == 0xABCD);
  CHECK(flash_byte(&rows[0].small) == 1);
}

}  // namespace
