// Clauses about brakes, bridges, relay, actuators and lamps.
#include <algorithm>

#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

bool is_braked_late_at_neutral(const Scene& scene) {
  const auto since = scene.stick.neutral_since();
  return since && scene.wheels.is_a_brake_released() &&
         std::min(scene.wheels.zero_for(), scene.now - *since) > limits::brakes_at_rest;
}

bool is_braked_late(const Scene& scene, bool in_emergency) {
  const auto since = scene.leave.denied_since();
  return since && is_emergency(scene.leave.first_reason()) == in_emergency && scene.wheels.is_a_brake_released() &&
         std::min(scene.wheels.zero_for(), scene.now - *since) > limits::brakes_after_stop;
}

bool is_let_go_without_leave(const Scene& scene) {
  if (!scene.wheels.has_begun_to_release()) {
    return false;
  }
  const auto neutral = scene.stick.neutral_since();
  const bool is_at_rest = neutral && scene.wheels.before_at() - *neutral >= limits::reaction;
  return scene.is_denied() || is_at_rest || scene.silence() >= limits::silence;
}

bool has_torque_too_soon(const Scene& scene) {
  const bool begins = scene.wheels.was_zero() && !scene.wheels.is_zero();
  return begins && scene.wheels.released_for() < limits::brake_release;
}

bool is_relay_closed_without_leave(const Scene& scene) {
  return scene.wheels.pins().motor_relay && scene.is_denied() && scene.wheels.still_for() > limits::reaction;
}

bool drives_and_actuates(const Scene& scene) {
  return scene.actuators.is_on() && !scene.wheels.is_still();
}

bool actuates_under_a_reason(const Scene& scene, Time allowed) {
  const auto since = scene.leave.denied_to_actuators_since();
  return since && scene.now - *since > allowed;
}

bool keeps_an_actuator_on(const Scene& scene) {
  return scene.actuators.is_on() && actuates_under_a_reason(scene, limits::actuators_off);
}

bool begins_an_actuator_without_leave(const Scene& scene) {
  return scene.actuators.has_begun() && actuates_under_a_reason(scene, limits::reaction);
}

bool lights_without_lighting(const Scene& scene) {
  return scene.lamps.is_lit() && scene.unlit_since && scene.now - *scene.unlit_since > limits::lamps_off;
}

bool is_on_after_reset(const Scene& scene) {
  return scene.was_reset && (!scene.wheels.is_still() || scene.wheels.pins().bridge_enable);
}

bool lights_for_an_old_remote(const Scene& scene) {
  const Pins& pins = scene.wheels.pins();
  return scene.old_since && scene.now - *scene.old_since > limits::lamps_off &&
         (pins.left_indicator || pins.right_indicator || pins.headlight || scene.actuators.is_on());
}

}  // namespace

// clang-format off
std::vector<Clause> brake_clauses() {
  using M = Moment;
  return {
      {"H-03.3", "A stick at rest and no duty: the brakes engage after their engage time",
       "850 ms", "SB-00.8", M::millisecond, is_braked_late_at_neutral},
      {"H-04.3", "Emergency stop: the brakes are engaged 250 ms after the duties are zero",
       "samples", "SB-2.17", M::millisecond, [](const Scene& scene) { return is_braked_late(scene, true); }},
      {"H-10.1", "The motor relay is open while nothing may drive and the brakes are engaged",
       "5 ms", "SB-2.17, SB-3.9", M::millisecond, is_relay_closed_without_leave},
      {"H-12.1", "Brakes are let go only with leave to drive, for a fresh general with the stick deflected",
       "5 ms; a general is fresh for 62 ms", "SB-2.17, SB-01.8", M::millisecond, is_let_go_without_leave},
      {"H-12.2", "Both brakes switch together",
       "never apart in two samples running", "SB-2.17", M::millisecond, [](const Scene& scene) { return scene.wheels.are_brakes_at_odds(); }},
      {"H-12.3", "A brake is released only while bridge and motor relay are on, or the chair rolls freely",
       "two samples running", "SB-2.17", M::millisecond, [](const Scene& scene) { return scene.wheels.is_loose_brake(); }},
      {"H-13.1", "No duty against an engaged brake",
       "two samples running", "SB-2.17", M::millisecond, [](const Scene& scene) { return scene.wheels.is_braked_torque(); }},
      {"H-13.2", "No duty before both brakes have had their release time",
       "100 ms less two samples", "SB-2.17", M::millisecond, has_torque_too_soon},
      {"H-17.1", "Drive and actuators are never on together",
       "any sample", "SB-00.7", M::millisecond, drives_and_actuates},
      {"H-18.1", "An actuator is never told to extend and to retract",
       "any sample", "SB-00.7", M::millisecond, [](const Scene& scene) { return scene.actuators.goes_both_ways(); }},
      {"H-18.2", "An actuator runs only while the driver's generals ask for its mode with the stick deflected its way: forward extends",
       "off 100 ms after the last; 30 off 512 is deflected", "SB-00.7, SB-3.7", M::millisecond, [](const Scene& scene) { return scene.actuators.is_unasked(); }},
      {"H-18.3", "An actuator runs only in a mode that was told, as valid, and that includes it",
       "a turn", "SB-00.7, SB-3.7, SB-3.8", M::millisecond, [](const Scene& scene) { return scene.actuators.is_outside_its_mode(); }},
      {"H-18.4", "Emergency, inhibit, fault, lock, calibration, change of driver or mode: all actuators go off",
       "100 ms", "SB-2.17, SB-00.4, SB-00.6, SB-08.2", M::millisecond, keeps_an_actuator_on},
      {"H-18.5", "No actuator starts under one of these, nor before neutral was seen in its mode",
       "5 ms", "SB-00.7, SB-01.8", M::millisecond, begins_an_actuator_without_leave},
      {"H-18.6", "An actuator rests between extend and retract",
       "400 ms", "SB-00.7", M::millisecond, [](const Scene& scene) { return scene.actuators.turns_round_too_soon(); }},
      {"H-18.7", "No actuator is on for longer than 61 s",
       "samples", "SB-00.7", M::millisecond, [](const Scene& scene) { return scene.actuators.is_on_too_long(); }},
      {"H-19.6", "An inhibit, another mode or the power button: the brakes are engaged 250 ms after the duties are zero",
       "samples", "SB-00.4, SB-00.5, SB-00.6, SB-4.1", M::millisecond, [](const Scene& scene) { return is_braked_late(scene, false); }},
      {"H-25.1", "A reset switches duties, bridge and brakes off at once",
       "the first sample after it", "SB-3.9", M::millisecond, is_on_after_reset},
      {"H-32.1", "An old remote with six data bytes: lamps and actuators are off",
       "100 ms after the first such general", "SB-00.3", M::millisecond, lights_for_an_old_remote},
      {"H-32.3", "No lamp is lit unless both power-up packets, the power module's and the remote's with eight data bytes, tell of lighting",
       "off 100 ms after one that does not", "SB-3.6, SB-04.2", M::millisecond, lights_without_lighting},
      {"H-32.4", "No lamp is lit unless the remote asks for it",
       "off 100 ms after the first general that does not; in silence the last one holds", "SB-3.6, SB-00.2", M::millisecond,
       [](const Scene& scene) { return scene.lamps.is_unasked(); }},
  };
}
// clang-format on

}  // namespace simulation::monitor
