// `pilotfish powercut`: the supply fails at every byte that the flashed image writes into its EEPROM, whatever the cell
// then holds, and the image starts again (H-20, SB-4.3).
//
// Goals: every cut that can happen is made on the very image; a person understands the table.
// Assumptions: a write that is cut leaves anything in its one cell and touches no other. The settings' version and
// number are those of the image's own .eep file.
// Invariants: the judge (judge.hpp) shares no code with the product; the same seed gives the same cases.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "simulation/report/page.hpp"

namespace simulation::powercut {

struct Order {
  std::string image;
  bool wants_all = false;  // every outcome of every byte, and every pair of two cuts
  std::uint64_t seed = 1;
  bool is_verbose = false;  // tells on `err` how fast it was
  report::Palette palette;
};

// Exit code: 0 all cases safe, 1 some are not, 2 the image or its .eep file cannot be used.
// What goes to `out` is the same on every run.
int run(const Order& order, std::ostream& out, std::ostream& err);

}  // namespace simulation::powercut
