// Clauses about the power latch.
#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

bool is_unlatched_in_motion(const Scene& scene) {
  return scene.is_powered && !scene.wheels.pins().power_latch && !scene.wheels.is_still();
}

bool is_latched_late(const Scene& scene) {
  return scene.is_powered && !scene.supply.was_latched() && scene.supply.powered_for(scene.now) > limits::latch;
}

bool lets_go_without_reason(const Scene& scene) {
  return scene.is_powered && scene.supply.has_let_go() && !scene.supply.may_let_go(scene.now);
}

}  // namespace

// clang-format off
std::vector<Clause> power_clauses() {
  using M = Moment;
  return {
      {"H-04.4", "The remote is gone: the latch is let go after 5000 ms, after 500 ms with power down now, and rest",
       "20 ms later at most", "SB-4.4", M::millisecond, [](const Scene& scene) { return scene.supply.is_overdue_after_silence(scene.now); }},
      {"H-14.1", "The latch is held while there is a duty or a released brake",
       "any sample", "SB-4.5", M::millisecond, is_unlatched_in_motion},
      {"H-15.1", "The latch is held soon after power or reset",
       "20 ms", "SB-1.2", M::millisecond, is_latched_late},
      {"H-16.2", "The latch is let go only after two confirms in a row of a told power down now, or when the remote is gone",
       "gone for 4980 ms, or 480 ms with power down now; a module that never spoke has heard nobody", "SB-4.3, SB-4.4", M::millisecond, lets_go_without_reason},
      {"H-16.3", "Confirmed and at rest, the latch is let go",
       "200 ms", "SB-4.3", M::millisecond, [](const Scene& scene) { return scene.supply.is_overdue_after_confirm(scene.now); }},
  };
}
// clang-format on

}  // namespace simulation::monitor
