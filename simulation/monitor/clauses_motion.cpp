// Clauses about the wheels: when a duty may grow, how fast, and how soon it must fall.
#include <algorithm>

#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

template <Reason reason>
bool grows_under(const Scene& scene) {
  return scene.wheels.has_grown() && scene.is_denied(reason);
}

template <Reason one, Reason other>
bool grows_under_either(const Scene& scene) {
  return grows_under<one>(scene) || grows_under<other>(scene);
}

bool grows_calibrating(const Scene& scene) {
  return grows_under_either<Reason::calibration, Reason::attendant_calibration>(scene) ||
         grows_under<Reason::told_calibration>(scene);
}

// Above the straight line from `largest` to zero that takes `from_full` from full speed.
bool is_above_line(int duty, int largest, Time elapsed, Time from_full) {
  const double steps = static_cast<double>(limits::full_duty) *
                       static_cast<double>((elapsed - limits::reaction).count()) /
                       static_cast<double>(from_full.count());
  return duty > std::max(0.0, largest - std::max(0.0, steps)) + limits::rounding;
}

bool grows_without_fresh_general(const Scene& scene) {
  return scene.wheels.has_grown() && scene.silence() >= limits::silence;
}

bool grows_at_neutral(const Scene& scene) {
  const auto since = scene.stick.neutral_since();
  return since && scene.now - *since >= limits::reaction && scene.wheels.has_grown();
}

bool slows_too_little_at_neutral(const Scene& scene) {
  const auto since = scene.stick.neutral_since();
  return since && is_above_line(scene.wheels.largest(), scene.stick.duty_at_release(), scene.now - *since,
                                limits::slowest_release);
}

bool slows_too_little(const Scene& scene, bool in_emergency) {
  return scene.fall && is_emergency(scene.fall->reason) == in_emergency &&
         is_above_line(scene.wheels.largest(), scene.fall->largest, scene.now - scene.fall->from,
                       limits::emergency_stop);
}

bool is_too_fast_limping(const Scene& scene) {
  const auto lasts = [&](const std::optional<Time>& since) { return since && scene.now - *since > limits::limp_ramp; };
  return scene.wheels.largest() > limits::limp_duty &&
         (lasts(scene.limp.caused) || lasts(scene.limp.non_critical) || lasts(scene.limp.of_attendant));
}

}  // namespace

// clang-format off
std::vector<Clause> motion_clauses() {
  using M = Moment;
  return {
      {"H-01.1", "No duty grows without a fresh general of the remote, and of the attendant control while that drives",
       "62 ms after the last valid one, between two samples", "SB-2.15, SB-08.5", M::millisecond, grows_without_fresh_general},
      {"H-01.2", "No duty grows before the first general after a power-up packet",
       "5 ms", "SB-3.1", M::millisecond, grows_under<Reason::power_up_phase>},
      {"H-02.1", "After power-up, reset, emergency stop, inhibit, another mode or another driver no duty grows before 5 generals of the driver in a row were neutral",
       "neutral = both axes 30 off 512 at most; 5 ms", "SB-01.8, SB-2.17", M::millisecond, grows_under<Reason::neutral>},
      {"H-02.4", "A change of driver: no duty grows until the chair has come to a stand",
       "5 ms", "SB-08.2", M::millisecond, grows_under<Reason::hand_over>},
      {"H-03.1", "A stick at rest: no duty grows",
       "from 5 ms after the first neutral general on", "SB-00.8", M::millisecond, grows_at_neutral},
      {"H-03.2", "A stick at rest: the duties fall at the normal rate, from full to zero in 3125 ms",
       "the larger of both, 2 steps, 5 ms", "SB-00.8", M::millisecond, slows_too_little_at_neutral},
      {"H-04.1", "Silence: from 62 ms after the last valid general on no duty grows until the stop is over and the link has proved itself",
       "5 ms", "SB-2.15, SB-2.16, SB-2.17", M::millisecond, grows_under<Reason::silence>},
      {"H-04.2", "Emergency stop: the duties fall at the emergency rate, from full to zero in 1500 ms",
       "the larger of both, 2 steps, 5 ms", "SB-2.17", M::millisecond, [](const Scene& scene) { return slows_too_little(scene, true); }},
      {"H-04.5", "Silence of an attendant control that drives: no duty grows until the stop is over and its link has proved itself",
       "62 ms after its last valid general, then 5 ms", "SB-08.5, SB-2.16, SB-2.17", M::millisecond, grows_under<Reason::attendant_silence>},
      {"H-05.1", "Three corrupt packets in a row: no duty grows until the stop is over and the link has proved itself",
       "5 ms; packets that collide are not counted", "SB-2.14, SB-2.16, SB-2.17", M::millisecond, grows_under<Reason::corrupt>},
      {"H-07.3", "LIMP: no duty exceeds 41 %",
       "from 1500 ms after its cause on", "SB-2.16, SB-00.6", M::millisecond, is_too_fast_limping},
      {"H-09.1", "A remote that starts anew: no duty grows until the stop is over and the link has proved itself",
       "5 ms", "SB-3.4, SB-2.17", M::millisecond, grows_under<Reason::restart>},
      {"H-09.3", "An attendant control that starts anew while it drives: no duty grows until the stop is over and its link has proved itself",
       "5 ms", "SB-08.5, SB-2.17", M::millisecond, grows_under<Reason::attendant_restart>},
      {"H-11.1", "A duty passes zero before it changes its sign",
       "two samples; up to 8 steps, both sides together, may be made at once", "SB-00.8", M::millisecond,
       [](const Scene& scene) { return scene.wheels.has_flipped(); }},
      {"H-11.2", "The chair does not gather speed against the stick",
       "the sum of both duties, 8 steps; not while a motor has too much current (H-33.2)", "SB-00.8", M::millisecond,
       [](const Scene& scene) { return scene.stick.drives_against() > limits::made_up_at_once; }},
      {"H-11.3", "The chair does not begin to turn against the stick",
       "the difference of both duties, 8 steps; not while a motor has too much current (H-33.2)", "SB-00.8", M::millisecond,
       [](const Scene& scene) { return scene.stick.turns_against() > limits::made_up_at_once; }},
      {"H-16.4", "An accepted press of the power button: no duty grows any more",
       "pressed for 52 ms, then 5 ms", "SB-4.1", M::millisecond, grows_under<Reason::power_button>},
      {"H-17.4", "Another mode than Drive is requested: no duty grows",
       "5 ms", "SB-00.7", M::millisecond, grows_under<Reason::mode>},
      {"H-19.1", "Remote inhibit, or that of an attendant control that was acknowledged: no duty grows, whoever drives",
       "5 ms", "SB-00.4, SB-08.5", M::millisecond, grows_under_either<Reason::remote_inhibit, Reason::attendant_inhibit>},
      {"H-19.2", "Charger inhibit: no duty grows", "5 ms", "SB-00.5", M::millisecond, grows_under<Reason::charger_inhibit>},
      {"H-19.3", "Joystick error of the module that drives, or local fault of either: no duty grows",
       "5 ms", "SB-00.6, SB-08.1", M::millisecond, grows_under_either<Reason::remote_fault, Reason::attendant_fault>},
      {"H-19.4", "Joystick calibration, reported or told: no duty grows", "5 ms", "SB-01.10", M::millisecond, grows_calibrating},
      {"H-19.5", "An inhibit, another mode or driver, or the power button: the duties fall as in an emergency stop",
       "the larger of both, 2 steps, 5 ms", "SB-00.4, SB-00.5, SB-00.6, SB-00.7, SB-01.10, SB-4.1", M::millisecond,
       [](const Scene& scene) { return slows_too_little(scene, false); }},
      {"H-19.9", "Told locked, no duty grows", "5 ms", "SB-01.1", M::millisecond, grows_under<Reason::told_lock>},
      {"H-31.1", "No motor has more than 80 A for long",
       "60 ms", "SB-01.9", M::millisecond, [](const Scene& scene) { return scene.wheels.is_overloaded_for(limits::longest_overload); }},
      {"H-31.2", "No duty grows while it drives its motor with more than the peak current",
       "above 62 A for 25 ms", "SB-01.9", M::millisecond, [](const Scene& scene) { return scene.wheels.grows_above_peak(); }},
      {"H-33.1", "No duty grows faster than from zero to full in 248 ms",
       "steps of up to 4 ms may be made at once", "SB-01.8, SB-2.16", M::millisecond,
       [](const Scene& scene) { return scene.wheels.rises_too_fast(); }},
      {"H-33.2", "No duty falls faster than from full to zero in 248 ms, unless bridge, relay and brakes go with it or its motor has too much current",
       "steps of up to 4 ms may be made at once; driven with more than 60 A, and 25 ms after it: any",  "SB-2.17", M::millisecond,
       [](const Scene& scene) { return scene.wheels.falls_too_fast(); }},
  };
}
// clang-format on

}  // namespace simulation::monitor
