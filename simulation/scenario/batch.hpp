// `pilotfish run`: files, machines, verdicts, exit code.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "simulation/report/page.hpp"

namespace simulation::scenario {

struct Order {
  std::vector<std::string> files;
  std::string on = "avr";
  std::string image;
  std::string folder;  // empty: write no files
  std::optional<std::uint64_t> seed;
  bool wants_log = false;
  bool is_quiet = false;
  bool is_verbose = false;
  report::Palette palette;
};

// Exit code: 0 passed, 1 an expectation failed or machines disagree, 2 a bad file or image, 3 simulation error.
// What goes to `out` is the same on every run; wall-clock times and usage errors go to `err`.
int play_all(const Order& order, std::ostream& out, std::ostream& err);

}  // namespace simulation::scenario
