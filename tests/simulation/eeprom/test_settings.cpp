// An EEPROM with chosen settings: literal places and numbers, from the list of settings and docs/architecture.md.
#include "simulation/eeprom/settings.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace simulation::eeprom {
namespace {

unsigned word(const Bytes& bytes, std::size_t at) {
  return bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8;
}

}  // namespace

TEST_CASE("Settings have their names, defaults and ranges", "[negotiation]") {
  const auto& rows = known_settings();
  REQUIRE(rows.size() > 2);
  CHECK(rows[0].name == "deadband");
  CHECK(rows[0].initial == 30);
  CHECK(rows[0].least == 10);
  CHECK(rows[0].most == 100);
  CHECK(rows[0].unit == "counts");
  CHECK(rows[1].name == "stick_travel");
  CHECK(rows[1].initial == 475);
}

TEST_CASE("An image holds what was chosen, and the defaults, in two sound copies", "[H-20][negotiation]") {
  const Bytes image = make_image({{"stick_travel", 300}});
  REQUIRE(image.size() == 4096);
  const auto count = static_cast<std::uint8_t>(known_settings().size());
  for (std::size_t copy = 0; copy < 2; ++copy) {
    const SettingsCopy read = read_copy(image, copy, image[1], count);
    CHECK(read.is_sound);
    CHECK(std::size_t{read.sequence} == copy);
    CHECK(word(read.values, 0) == 30);
    CHECK(word(read.values, 2) == 300);
    CHECK(word(read.values, 4) == 220);
  }
  const auto rest = image.begin() + 256;
  CHECK(std::all_of(rest, image.end(), [](std::uint8_t byte) { return byte == 0xFF; }));
  CHECK(read_log(image).empty());
}

}  // namespace simulation::eeprom
