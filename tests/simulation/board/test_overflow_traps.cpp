// The image with traps stops where arithmetic goes beyond 16 bits; without traps the same program runs on.
#include "tests/simulation/board/bench.hpp"

namespace simulation {

TEST_CASE("the traps image stops at each mistake that the AVR itself would pass over") {
  const auto choice = GENERATE(as<std::uint8_t>(), 1, 2, 3, 4);  // sum, shift, index, product
  CAPTURE(int{choice});

  Bench trapped("overflow", {choice}, 0, PILOTFISH_TRAPS_DIR);
  trapped.start().run(1ms);
  CHECK_FALSE(trapped.board->statistics().complaints.empty());
  CHECK(trapped.byte("is_done") == 0);

  Bench flashed("overflow", {choice});
  flashed.start().run(1ms);
  CHECK(flashed.board->statistics().complaints.empty());
  CHECK(flashed.byte("is_done") == 1);
}

TEST_CASE("the traps image leaves sound arithmetic alone") {
  Bench bench("overflow", {0}, 0, PILOTFISH_TRAPS_DIR);
  bench.start().run(1ms);
  CHECK(bench.board->statistics().complaints.empty());
  CHECK(bench.byte("is_done") == 1);
}

}  // namespace simulation
