// Clauses about what the power module tells: it must be true of what can be seen.
#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

// Something was so for a whole turn before the power module began to speak.
bool was_so(const Scene& scene, const std::optional<Time>& since) {
  return since && scene.speech.began() - *since > limits::turn;
}

// What the attendant control said last, if that is certain, before the power module spoke, and not long ago.
std::optional<SacuGeneral> heard_of_attendant(const Scene& scene) {
  const auto& last = scene.attendant.last();
  const Time age = last ? scene.speech.began() - last->end : Time{};
  const bool counts = last && !last->is_doubtful && age > limits::reaction && age < limits::silence;
  return counts ? last : std::nullopt;
}

bool hides_neutral_awaited(const Scene& scene) {
  if (!was_so(scene, scene.leave.since(Reason::neutral)) || scene.said.general->locked) {
    return false;
  }
  const auto& answered = scene.speech.answered().general;
  const bool is_held = answered && !answered->is_doubtful && !answered->is_neutral();
  if (scene.drove(Driver::remote)) {
    return is_held && !scene.said.general->drive_modified;
  }
  const auto of_attendant = heard_of_attendant(scene);
  return scene.drove(Driver::attendant) && of_attendant && !of_attendant->is_neutral() &&
         !scene.said.general->attendant_modified;
}

bool tells_neutral_awaited_to_the_other(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  return told.sacu_drives ? told.drive_modified : told.attendant_modified;
}

bool hides_limp(const Scene& scene) {
  return was_so(scene, scene.limp.caused) && !scene.said.general->slowdown;
}

bool lifts_limp_too_soon(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  if (scene.said.general->slowdown) {
    return false;
  }
  return (was_so(scene, scene.limp.non_critical) && answered && !answered->is_doubtful) ||
         (was_so(scene, scene.limp.of_attendant) && heard_of_attendant(scene));
}

bool takes_limp_back(const Scene& scene) {
  return scene.limp.is_latched_as_told && !scene.said.general->slowdown;
}

bool tells_another_mode(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  const int told = scene.said.general->mode;
  const auto of_attendant = heard_of_attendant(scene);
  if (scene.drove(Driver::attendant)) {
    return of_attendant && told != of_attendant->mode;
  }
  return scene.drove(Driver::remote) && answered && !answered->is_doubtful && told != answered->mode;
}

bool misuses_invalid(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  const auto& before = scene.report_before;
  const bool was_established = before && before->mode == told.mode && !before->is_invalid() &&
                               before->sacu_drives == told.sacu_drives && !scene.old_since;
  const bool is_undefined = told.mode > 3;
  return told.is_invalid() ? told.mode == 0 || was_established : is_undefined;
}

bool misplaces_invalid(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  return told.sacu_drives ? told.mode_invalid : told.attendant_mode_invalid;
}

bool exceeds_capabilities(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  if (!told.is_actuator_mode()) {
    return false;
  }
  const int needed = (told.mode & 1 ? Capabilities::actuator1 : 0) | (told.mode & 2 ? Capabilities::actuator2 : 0);
  const int of_driver = told.sacu_drives ? scene.attendant.capabilities() : scene.remote_capabilities;
  return (needed & ~(scene.own_capabilities.value_or(needed) & of_driver)) != 0;
}

bool tells_another_driver(const Scene& scene) {
  return scene.drove(scene.said.general->sacu_drives ? Driver::remote : Driver::attendant);
}

bool tells_driving_wrongly(const Scene& scene) {
  const Time rests = scene.now - scene.actuators.on_at();
  const bool is_at_rest = scene.wheels.still_for() > limits::turn && rests > limits::turn;
  const bool is_at_work = scene.wheels.busy_for() > limits::turn || scene.actuators.busy_for() > limits::turn;
  return scene.said.general->system_drives ? is_at_rest : is_at_work;
}

bool grows_though_told_inhibited(const Scene& scene) {
  return scene.told_inhibited && scene.wheels.has_grown() &&
         scene.wheels.before_at() - *scene.told_inhibited >= limits::reaction;
}

bool hides_inhibit(const Scene& scene) {
  if (scene.said.general->drive_inhibited) {
    return false;
  }
  return was_so(scene, scene.said.general->is_actuator_mode() ? scene.leave.denied_but_for_mode_since()
                                                              : scene.leave.denied_since());
}

bool asks_for_power_down_unasked(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  const bool may_sleep = told.sleep_requested && scene.supply.may_sleep(scene.now);
  const bool may_give_up = told.locked && scene.supply.may_give_up_lock(scene.now);
  return told.power_down_now && !scene.supply.may_ask() && !may_sleep && !may_give_up;
}

bool shows_lamps_to_an_old_remote(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  const SpmGeneral& told = *scene.said.general;
  const bool shows_mode = told.mode != 0 && !(told.sacu_drives && told.is_invalid());
  return was_so(scene, scene.old_since) && answered && answered->is_old &&
         (scene.said.general->shows_lamps || shows_mode);
}

bool tells_of_lamps_without_lighting(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  return was_so(scene, scene.unlit_since) && (told.shows_lamps || told.lamp_fault);
}

bool tells_of_lamps_unasked(const Scene& scene) {
  const auto& answered = scene.speech.answered().general;
  if (!answered || answered->is_doubtful) {
    return false;
  }
  const SpmGeneral& told = *scene.said.general;
  return (told.hazard && !answered->hazard) || (told.headlight && !answered->headlight) ||
         (told.left && (!answered->left || answered->hazard)) || (told.right && (!answered->right || answered->hazard));
}

bool tells_another_cadence(const Scene& scene) {
  const SpmGeneral& told = *scene.said.general;
  return !told.lamp_fault &&
         (told.cadence ? scene.lamps.are_indicators_steadily_dark() : scene.lamps.are_indicators_steadily_lit());
}

}  // namespace

// clang-format off
std::vector<Clause> report_clauses() {
  using M = Moment;
  return {
      {"H-02.2", "The driver's deflected stick while neutral is awaited is told by the driver's temporary drive modification bit",
       "a turn; not while lock is told", "SB-01.3, SB-01.5, SB-01.8", M::general, hides_neutral_awaited},
      {"H-02.3", "The temporary drive modification bit of the module that does not drive is clear",
       "exact, by the driver told", "SB-01.8", M::general, tells_neutral_awaited_to_the_other},
      {"H-06.1", "LIMP by the remote's non-critical fault is told until five generals in a row came without it, by an acknowledged attendant control's while it sets it",
       "a turn", "SB-00.6, SB-2.16", M::general, lifts_limp_too_soon},
      {"H-07.1", "After an emergency or a pot error LIMP is told until power-down",
       "a turn", "SB-2.14, SB-2.15, SB-2.16, SB-00.6, SB-01.1", M::general, hides_limp},
      {"H-07.2", "A LIMP that was told with a cause, and not by a module's non-critical fault, is never taken back",
       "told in the seventh answer since that fault was last heard, or later; states 00 and 01 are no cause", "SB-2.16", M::general, takes_limp_back},
      {"H-16.1", "Power down now is told only after a press of the button was released, with sleep after its time, or locked for 10 s",
       "48 ms are a press; 15 min less 1 s are sleep; 9.9 s are locked", "SB-4.1, SB-4.2, SB-01.1", M::general, asks_for_power_down_unasked},
      {"H-17.2", "The mode told is the driver's request: the remote's in the general that is answered, the attendant control's in its last",
       "exact; from a turn after a change of driver on", "SB-00.7", M::general, tells_another_mode},
      {"H-17.3", "Mode invalid is never told with mode 0 nor of an established mode, and always of modes 4 to 15",
       "exact; not for another driver or an old remote", "SB-00.7, SB-01.6, SB-08.4", M::general, misuses_invalid},
      {"H-17.5", "SACU drives is told while an acknowledged attendant control's last general had its switch on, and only then",
       "a turn", "SB-08.2, SB-09.1, SB-01.4", M::general, tells_another_driver},
      {"H-17.6", "The attendant control's power-up is acknowledged only after it was heard, then until its first general, and not longer",
       "5 ms", "SB-09.1, SB-01.5", M::general, [](const Scene& scene) { return scene.attendant.is_acknowledged_wrongly(); }},
      {"H-17.7", "The mode invalid bit of the module that does not drive is clear",
       "exact, by the driver told", "SB-08.4, SB-01.6, SB-01.7", M::general, misplaces_invalid},
      {"H-17.8", "Modes 1 to 3 are told as valid only if the power-up packets of power module and driver both tell of these actuators",
       "exact, by the driver told", "SB-3.7, SB-3.8, SB-05.1", M::general, exceeds_capabilities},
      {"H-17.9", "System is driving is told while there is a duty or an actuator is on, and not while the brakes are engaged and all actuators off",
       "a turn", "SB-01.4", M::general, tells_driving_wrongly},
      {"H-19.7", "Told inhibited, no duty grows until another general is heard",
       "5 ms", "SB-01.2", M::millisecond, grows_though_told_inhibited},
      {"H-19.8", "While there is a reason not to drive, drive inhibited is told",
       "a turn; in a valid actuator mode neither that nor neutral is a reason", "SB-01.2", M::general, hides_inhibit},
      {"H-32.2", "An old remote with six data bytes is told mode 0 and no lamps",
       "a turn; the attendant control's mode is then told as invalid", "SB-00.3", M::general, shows_lamps_to_an_old_remote},
      {"H-32.5", "No lamp status, cadence or fault is told unless both power-up packets tell of lighting",
       "a turn", "SB-3.6, SB-04.2", M::general, tells_of_lamps_without_lighting},
      {"H-32.6", "No lamp status is told that the general answered does not ask for, and neither side with hazard",
       "exact", "SB-3.6, SB-01.4", M::general, tells_of_lamps_unasked},
      {"H-32.7", "The cadence bit is set while an indicator is lit and clear while none is",
       "a turn; not while a lamp fault is told", "SB-01.4", M::general, tells_another_cadence},
  };
}
// clang-format on

}  // namespace simulation::monitor
