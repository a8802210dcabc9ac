// Clauses about what the power module tells: it must be true of what can be seen.
#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

// Something was so for a whole turn before the power module began to speak.
bool was_so(const Scene& scene, const std::optional<Time>& since) {
  return since && scene.speech.began() - *since > limits::turn;
}

bool hides_neutral_awaited(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  return was_so(scene, scene.leave.since(Reason::neutral)) && answered && !answered->is_doubtful &&
         !answered->is_neutral() && !scene.said.general->drive_modified;
}

bool hides_limp(const Scene& scene) {
  return was_so(scene, scene.limp.caused) && !scene.said.general->slowdown;
}

bool lifts_limp_too_soon(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  return was_so(scene, scene.limp.non_critical) && answered && !answered->is_doubtful && !scene.said.general->slowdown;
}

bool takes_limp_back(const Scene& scene) {
  return scene.limp.is_latched_as_told && !scene.said.general->slowdown;
}

bool tells_another_mode(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  return answered && !answered->is_doubtful && !scene.said.general->sacu_drives &&
         scene.said.general->mode != answered->mode;
}

bool misuses_invalid(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  const auto& before = scene.report_before;
  const bool was_established = before && before->mode == told.mode && !before->mode_invalid;
  const bool is_undefined = told.mode > 3;
  return told.mode_invalid ? told.mode == 0 || was_established : is_undefined;
}

bool grows_though_told_inhibited(const Scene& scene) {
  return scene.told_inhibited && scene.wheels.has_grown() &&
         scene.wheels.before_at() - *scene.told_inhibited >= limits::reaction;
}

bool hides_inhibit(const Scene& scene) {
  return was_so(scene, scene.leave.denied_since()) && !scene.said.general->drive_inhibited;
}

bool asks_for_power_down_unasked(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  const bool may_sleep = told.sleep_requested && scene.supply.may_sleep(scene.now);
  return told.power_down_now && !scene.supply.may_ask() && !may_sleep;
}

bool shows_lamps_to_an_old_remote(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  return was_so(scene, scene.old_since) && answered && answered->is_old &&
         (scene.said.general->shows_lamps || scene.said.general->mode != 0);
}

}  // namespace

// clang-format off
std::vector<Clause> report_clauses() {
  using M = Moment;
  return {
      {"H-02.2", "A deflected stick while neutral is awaited is told by the temporary drive modification bit",
       "a turn", "SB-01.3, SB-01.8", M::general, hides_neutral_awaited},
      {"H-06.1", "LIMP by the remote's non-critical fault is told until five generals in a row came without it",
       "a turn", "SB-00.6, SB-2.16", M::general, lifts_limp_too_soon},
      {"H-07.1", "After an emergency or a pot error LIMP is told until power-down",
       "a turn", "SB-2.14, SB-2.15, SB-2.16, SB-00.6, SB-01.1", M::general, hides_limp},
      {"H-07.2", "A LIMP that was told with a cause, and not by the remote's non-critical fault, is never taken back",
       "told in the seventh answer since that fault was last heard, or later", "SB-2.16", M::general, takes_limp_back},
      {"H-16.1", "Power down now is told only after a press of the button was released, or with sleep after its time",
       "48 ms are a press; 15 min less 1 s are sleep", "SB-4.1, SB-4.2", M::general, asks_for_power_down_unasked},
      {"H-17.2", "The mode told is the mode requested in the general that is answered",
       "exact", "SB-00.7", M::general, tells_another_mode},
      {"H-17.3", "Mode invalid is never told with mode 0 nor of an established mode, and always of modes 4 to 15",
       "exact", "SB-00.7, SB-01.6", M::general, misuses_invalid},
      {"H-19.7", "Told inhibited, no duty grows until another general is heard",
       "5 ms", "SB-01.2", M::millisecond, grows_though_told_inhibited},
      {"H-19.8", "While there is a reason not to drive, drive inhibited is told",
       "a turn", "SB-01.2", M::general, hides_inhibit},
      {"H-32.2", "An old remote with six data bytes is told mode 0 and no lamps",
       "a turn", "SB-00.3", M::general, shows_lamps_to_an_old_remote},
  };
}
// clang-format on

}  // namespace simulation::monitor
