// The way from the stick to the wheels, for every position of the stick, on the chip and on the host.
#include "spm/settings.hpp"
#include "tests/simulation/board/bench.hpp"
#include "tests/vectors/sticks.hpp"

namespace simulation {
namespace {

using vectors::stick_blocks;
using vectors::StickOrder;

constexpr Time patience = 900s;

std::uint32_t double_word(const Bench& bench, const std::string& variable, unsigned index) {
  std::uint32_t value = 0;
  for (unsigned i = 4; i-- > 0;) {
    value = value << 8 | bench.byte(variable, 4 * index + i);
  }
  return value;
}

// All blocks on the chip, then on the host; how many positions were compared.
std::uint32_t compare(const StickOrder& order, const std::string& folder) {
  const std::vector<std::uint8_t> settings{static_cast<std::uint8_t>(order.is_one_pot), order.pot, order.speed_step};
  Bench bench("sticks", settings, 0, folder);
  bench.start();
  do {
    bench.run(20ms);
  } while (bench.now < patience && bench.byte("current") < stick_blocks &&
           bench.board->statistics().complaints.empty());
  CHECK(bench.board->statistics().complaints == std::vector<std::string>{});
  REQUIRE(bench.byte("current") == stick_blocks);
  const spm::DriveProfile profile = spm::make_profile(spm::Settings());
  std::uint32_t count = 0;
  for (unsigned block = 0; block < stick_blocks; ++block) {
    const vectors::StickDigest host = vectors::stick_block(static_cast<std::uint8_t>(block), order, profile);
    CAPTURE(block);
    CHECK(double_word(bench, "counts", block) == host.count());
    CHECK(double_word(bench, "digests", block) == host.value());
    count += host.count();
  }
  return count;
}

}  // namespace

TEST_CASE("every stick position comes to the same wheels on the chip as on the host", "[H-11][SB-00.8]") {
  CHECK(compare({false, 0, 1}, PILOTFISH_TEST_FIRMWARE_DIR) == 1048576);
}

TEST_CASE("every stick position is the same on the chip at both ends of the pot, in LIMP and without", "[H-11]") {
  const int pot = GENERATE(0, 255);
  CHECK(compare({true, static_cast<std::uint8_t>(pot), 1}, PILOTFISH_TEST_FIRMWARE_DIR) == 2097152);
}

TEST_CASE("every eighth row of stick positions overflows nothing on the chip", "[H-11]") {
  CHECK(compare({false, 0, 8}, PILOTFISH_TRAPS_DIR) == 131072);
}

// The long form: build/avr_tests "[campaign]"
TEST_CASE("every stick position at every fifteenth pot is the same on the chip", "[.][campaign]") {
  const int pot = GENERATE(range(0, 256, 15));
  CAPTURE(pot);
  CHECK(compare({true, static_cast<std::uint8_t>(pot), 1}, PILOTFISH_TEST_FIRMWARE_DIR) == 2097152);
}

TEST_CASE("every stick position, without an overflow on the chip", "[.][campaign]") {
  CHECK(compare({false, 0, 1}, PILOTFISH_TRAPS_DIR) == 1048576);
}

}  // namespace simulation
