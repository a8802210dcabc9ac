// What the flashed image does on the wire, measured at the pin of the simulated chip.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"
#include "simulation/world.hpp"

namespace simulation {
namespace {

struct SpmBytes : Observer {
  void on_byte(const BusByte& byte) override {
    if (byte.sender == Sender::spm) {
      bytes.push_back(byte);
    }
  }
  std::vector<BusByte> bytes;
};

}  // namespace

TEST_CASE("the image speaks at 38400 bps with two stop bits, 0.2 % off at most", "[SB-2.1]") {
  constexpr double one_character = 11 * 1e9 / 38400;  // nanoseconds: start, eight data, two stop bits
  SpmBytes spm;
  World world(make_avr_board({.image = std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf"}));
  world.observe(spm);
  world.remote().start(world.now());
  world.run_for(1s);

  int neighbours = 0;
  for (std::size_t i = 1; i < spm.bytes.size(); ++i) {
    const Time apart = spm.bytes[i].start - spm.bytes[i - 1].start;
    if (apart > 1ms) {  // another turn
      continue;
    }
    ++neighbours;
    CHECK(static_cast<double>(apart.count()) == Approx(one_character).epsilon(0.002));
    CHECK_FALSE(spm.bytes[i].spoiled);
  }
  CHECK(neighbours > 200);
}

}  // namespace simulation
