#include "drivers/self_test.hpp"

#include <algorithm>

#include "drivers/host/machine.hpp"

namespace drivers {
namespace self_test {

// What the chip would find while it runs: what was wrong when its turn came.
void start() {
  host::Machine& machine = host::selected();
  machine.self_test = Result::passed;
  machine.next_checked = 0;
  machine.is_round_wrong = false;
}

Result result() {
  return host::selected().self_test;
}

void step() {
  host::Machine& machine = host::selected();
  const auto& wrong = machine.wrong_flash;
  const auto first = wrong.lower_bound({machine.next_checked, 0});
  machine.next_checked += bytes_of_a_step;
  machine.is_round_wrong |= first != wrong.end() && first->first < machine.next_checked;
  if (machine.next_checked != checked_bytes) {
    return;
  }
  if (machine.is_round_wrong && machine.self_test == Result::passed) {
    machine.self_test = Result::flash_later;
  }
  machine.next_checked = 0;
  machine.is_round_wrong = false;
}

bool is_stack_intact() {
  return host::selected().is_stack_intact;
}

}  // namespace self_test
}  // namespace drivers
