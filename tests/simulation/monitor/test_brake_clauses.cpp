// Each clause about brakes, relay, actuators and lamps: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

// Brakes released, no duty, at the begin of a cycle.
Stage ready_to_roll() {
  Stage stage;
  stage.set_off();
  return stage;
}

}  // namespace

TEST_CASE("H-03.3: brakes stay released though the stick is at rest and no duty is left", "[monitor][H-03]") {
  const auto breaches = [](Time after) {
    Stage stage = ready_to_roll();
    stage.later(after, [&] { stage.brakes(false); });
    stage.cycles(43, sr::neutral, spm::ready);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(854ms), "H-03.3"));
  CHECK(breaches(853ms) == "");  // 850 ms after the first neutral general
}

TEST_CASE("H-04.3: brakes engage too late after an emergency stop", "[monitor][H-04]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.drive_at(20);
    stage.later(46ms, [&] { stage.drive(0, 0); });  // zero in the sample at 65 ms
    stage.later(65ms + after, [&] { stage.brakes(false); });
    stage.run(400ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(252ms), "H-04.3"));
  CHECK(breaches(251ms) == "");
}

TEST_CASE("H-10.1: the motor relay is closed though nothing may drive", "[monitor][H-10]") {
  const auto breaches = [](Time opens) {
    Stage stage;
    stage.wake_up();
    stage.pins.motor_relay = true;
    stage.cycle(sr::neutral, spm::ready);
    stage.later(opens, [&] { stage.pins.motor_relay = false; });
    stage.cycle(sr::inhibit_at_rest, spm::inhibited);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(10ms), "H-10.1"));
  CHECK(breaches(9ms) == "");
}

TEST_CASE("H-12.1: brakes are let go without leave to drive", "[monitor][H-12]") {
  const auto breaches = [](int neutrals) {
    Stage stage;
    stage.greet();
    stage.cycles(neutrals, sr::neutral, spm::inhibited);
    stage.cycle(sr::forward, spm::awaiting_neutral);
    stage.brakes(true);
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-12.1"));
  CHECK(breaches(5) == "");
}

TEST_CASE("H-12.1: brakes are let go though the stick is at rest", "[monitor][H-12]") {
  Stage stage;
  stage.wake_up();
  stage.brakes(true);
  stage.run(1ms);
  CHECK(stage.breaks("H-12.1"));
}

TEST_CASE("H-12.1: brakes are let go for a general that is too old", "[monitor][H-12]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.wake_up();
    stage.cycle(sr::forward, spm::ready);
    stage.later(after, [&] { stage.brakes(true); });
    stage.run(after);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(46ms), "H-12.1"));
  CHECK(breaches(45ms) == "");
}

TEST_CASE("H-12.2: one brake switches later than the other", "[monitor][H-12]") {
  const auto breaches = [](Time apart) {
    Stage stage = ready_to_roll();
    stage.pins.left_brake_release = false;
    stage.later(apart + 1ms, [&] { stage.brakes(false); });
    stage.cycle(sr::forward, spm::ready);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(2ms), "H-12.2"));
  CHECK(breaches(1ms) == "");
}

TEST_CASE("H-12.3: brakes are released without bridge or relay", "[monitor][H-12]") {
  const auto breaches = [](bool Pins::*pin, Time span) {
    Stage stage = ready_to_roll();
    stage.pins.*pin = false;
    stage.later(span + 1ms, [&, pin] { stage.pins.*pin = true; });
    stage.cycle(sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(&Pins::motor_relay, 2ms), "H-12.3"));
  CHECK(breaches(&Pins::motor_relay, 1ms) == "");
  CHECK(is_caught(breaches(&Pins::bridge_enable, 2ms), "H-12.3"));
  CHECK(breaches(&Pins::bridge_enable, 1ms) == "");
}

TEST_CASE("H-13.1: a duty against an engaged brake", "[monitor][H-13]") {
  const auto breaches = [](Time span) {
    Stage stage;
    stage.drive_at(20);
    stage.pins.left_brake_release = stage.pins.right_brake_release = false;
    stage.later(span + 1ms, [&] { stage.brakes(true); });
    stage.cycle(sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(2ms), "H-13.1"));
  CHECK(breaches(1ms) == "");
}

TEST_CASE("H-13.2: a duty before the brakes have had their release time", "[monitor][H-13]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.wake_up();
    stage.cycle(sr::forward, spm::ready);
    stage.brakes(true);  // shown 1 ms later
    stage.later(after, [&] { stage.drive(1, 1); });
    stage.cycles(6, sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(97ms), "H-13.2"));
  CHECK(breaches(98ms) == "");
}

TEST_CASE("H-17.1, H-18.2: an actuator runs while brakes are released, and unasked", "[monitor][H-17][H-18]") {
  Stage stage = ready_to_roll();
  stage.pins.actuator1_extend = true;
  stage.run(1ms);
  CHECK(stage.breaks("H-17.1"));
  CHECK(stage.breaks("H-18.2"));
}

TEST_CASE("H-18.1: the second actuator both ways", "[monitor][H-18]") {
  Stage stage;
  stage.wake_up();
  stage.pins.actuator2_extend = stage.pins.actuator2_retract = true;
  stage.run(1ms);
  CHECK(stage.breaks("H-18.1"));
}

TEST_CASE("H-19.6: brakes engage too late after a stop for an inhibit", "[monitor][H-19]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.drive_at(20);
    stage.drive(0, 0);  // zero in the sample at 20 ms
    stage.later(20ms + after, [&] { stage.brakes(false); });
    stage.cycles(15, sr::charger_inhibit, spm::awaiting_neutral);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(252ms), "H-19.6"));
  CHECK(breaches(251ms) == "");
}

TEST_CASE("H-25.1: something is still on after a reset", "[monitor][H-25]") {
  const auto breaches = [](bool all_off) {
    Stage stage;
    stage.drive_at(20);
    stage.reset();
    if (all_off) {
      stage.jump(0, 0);
      stage.brakes(false);
    }
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(false), "H-25.1"));
  CHECK(breaches(true) == "");
}

TEST_CASE("H-32.1: a lamp is lit for an old remote", "[monitor][H-32]") {
  const auto breaches = [](Time off_after) {
    Stage stage;
    stage.wake_up(spm::power_up_all);
    stage.cycle(sr::headlight, spm::headlight);
    stage.pins.headlight = true;
    stage.later(off_after, [&] { stage.pins.headlight = false; });
    stage.cycles(6, sr::old_neutral, spm::ready);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(104ms), "H-32.1"));
  CHECK(breaches(103ms) == "");  // the first such general ended at 2.3 ms
}
