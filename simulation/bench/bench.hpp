// `pilotfish bench`: how the flashed image does on an idle bus and under the heaviest traffic.
#pragma once

#include <optional>
#include <ostream>
#include <string>

namespace simulation::bench {

struct Order {
  std::string image;
  double minutes = 1;
  bool wants_json = false;
  std::optional<std::string> page;  // where to write docs/performance.md
};

// Exit code: 0 done, 1 a target was missed, 2 the image or the page cannot be used, 3 the
// simulation itself failed.
int run(const Order& order, std::ostream& out, std::ostream& err);

}  // namespace simulation::bench
