// Each clause about actuators: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

// In a mode that is told as valid, the stick seen at rest in so many generals.
Stage ready_to_move(const char* turn, const char* answer, int neutrals = 5) {
  Stage stage;
  stage.wake_up(spm::power_up_all);
  stage.cycles(neutrals, turn, answer);
  return stage;
}

// The first actuator extends, the last of three generals ended 17.4 ms ago.
Stage extending() {
  Stage stage = ready_to_move(sr::mode_1_at_rest, spm::mode_1_valid);
  stage.cycle(sr::mode_1, spm::mode_1_valid);
  stage.pins.actuator1_extend = true;
  stage.cycles(3, sr::mode_1, spm::mode_1_moving);
  return stage;
}

void stop(Stage& stage) {
  stage.pins.actuator1_extend = stage.pins.actuator1_retract = false;
  stage.pins.actuator2_extend = stage.pins.actuator2_retract = false;
}

}  // namespace

TEST_CASE("H-18.1: an actuator is told both ways", "[monitor][H-18]") {
  Stage stage = extending();
  CHECK(stage.breaches() == "");
  stage.pins.actuator1_retract = true;
  stage.run(1ms);
  CHECK(stage.breaks("H-18.1"));
}

TEST_CASE("H-18.2: an actuator runs on without a general", "[monitor][H-18]") {
  const auto breaches = [](Time after) {
    Stage stage = extending();
    stage.later(after, [&] { stop(stage); });
    stage.run(120ms);
    return stage.breaches();
  };
  CHECK(breaches(83ms) == "");
  CHECK(is_caught(breaches(84ms), "H-18.2"));
}

TEST_CASE("H-18.2: an actuator runs on though the stick is at rest or on its other side", "[monitor][H-18]") {
  const auto breaches = [](const char* turn, Time after) {
    Stage stage = extending();
    stage.later(after, [&] { stop(stage); });
    stage.cycles(6, turn, spm::mode_1_moving);
    return stage.breaches();
  };
  for (const char* turn : {sr::mode_1_at_rest, sr::mode_1_back}) {
    CHECK(breaches(turn, 83ms) == "");
    CHECK(is_caught(breaches(turn, 84ms), "H-18.2"));
  }
}

TEST_CASE("H-18.2, H-18.3: an actuator runs that its mode does not include", "[monitor][H-18]") {
  struct Case {
    const char* at_rest;
    const char* turn;
    const char* answer;
    bool first;
    bool second;
  };
  for (const Case& one : {Case{sr::mode_1_at_rest, sr::mode_1, spm::mode_1_valid, true, false},
                          Case{sr::mode_2_at_rest, sr::mode_2, spm::mode_2_valid, false, true},
                          Case{sr::mode_3_at_rest, sr::mode_3, spm::mode_3_valid, true, true}}) {
    for (const bool is_second : {false, true}) {
      CAPTURE(one.turn, is_second);
      Stage stage = ready_to_move(one.at_rest, one.answer);
      stage.cycle(one.turn, one.answer);
      (is_second ? stage.pins.actuator2_extend : stage.pins.actuator1_extend) = true;
      stage.cycles(2, one.turn, one.answer);
      const bool is_included = is_second ? one.second : one.first;
      CHECK(stage.breaches() == (is_included ? "" : "H-18.2 H-18.3"));
    }
  }
}

TEST_CASE("H-18.3: an actuator runs on though its mode is told as invalid", "[monitor][H-18]") {
  const auto is_broken = [](Time after) {
    Stage stage = extending();
    stage.later(after, [&] { stop(stage); });
    stage.cycles(3, sr::mode_1, spm::mode_1_invalid);  // told after 5.5 ms
    return stage.breaks("H-18.3");
  };
  CHECK(is_broken(32ms));
  CHECK_FALSE(is_broken(31ms));
}

TEST_CASE("H-18.4: an actuator runs on under an inhibit", "[monitor][H-18]") {
  const auto breaches = [](Time after) {
    Stage stage = extending();
    stage.later(after, [&] { stop(stage); });
    stage.cycles(6, sr::inhibited_mode_1, spm::mode_1_moving_inhibited);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(104ms), "H-18.4"));
  CHECK(breaches(103ms) == "");
}

TEST_CASE("H-18.4: an actuator runs on for another driver", "[monitor][H-18]") {
  const auto breaches = [](Time after) {
    Stage stage = ready_to_move(sr::mode_1_at_rest, spm::mode_1_valid);
    stage.trio(sr::mode_1_at_rest, spm::mode_1_valid, sacu::power_up);
    stage.trio(sr::mode_1_at_rest, "61 92 80 C0 80 90 81 80 BB 0F", sacu::standing_by);
    stage.trio(sr::mode_1, spm::mode_1_valid, sacu::standing_by);
    stage.pins.actuator1_extend = true;
    stage.later(after, [&] { stop(stage); });
    stage.trio(sr::mode_1, spm::mode_1_moving, sacu::mode_1);
    stage.trios(6, sr::mode_1, "61 92 C0 C0 E0 A0 81 80 8B 0F", sacu::mode_1);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(110ms), "H-18.4"));
  CHECK(breaches(109ms) == "");
}

TEST_CASE("H-18.5: an actuator starts before neutral was seen in its mode", "[monitor][H-18]") {
  const auto breaches = [](int neutrals) {
    Stage stage = ready_to_move(sr::mode_1_at_rest, spm::mode_1_valid, neutrals);
    stage.cycle(sr::mode_1, "61 92 80 E0 80 80 81 80 AB 0F");
    stage.pins.actuator1_extend = true;
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-18.5"));
  CHECK(breaches(5) == "");
}

TEST_CASE("H-18.6: an actuator turns round too soon", "[monitor][H-18]") {
  const auto breaches = [](Time pause) {
    Stage stage = extending();
    stop(stage);
    stage.later(pause, [&] { stage.pins.actuator1_retract = true; });
    stage.cycles(21, sr::mode_1_back, spm::mode_1_valid);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(399ms), "H-18.6"));
  CHECK(breaches(400ms) == "");
}

TEST_CASE("H-18.7: an actuator is on for too long", "[monitor][H-18]") {
  Stage stage = extending();  // for 60 ms
  stage.cycles(3047, sr::mode_1, spm::mode_1_moving);
  CHECK(stage.breaches() == "");
  stage.cycle(sr::mode_1, spm::mode_1_moving);
  CHECK(stage.breaks("H-18.7"));
}

TEST_CASE("H-17.9: system is driving is told of an actuator", "[monitor][H-17]") {
  Stage stage = extending();
  CHECK_FALSE(stage.breaks("H-17.9"));
  stage.cycle(sr::mode_1, spm::mode_1_valid);
  CHECK(stage.breaks("H-17.9"));
}

TEST_CASE("H-02.1, H-17.4: neutral in an actuator mode is none for driving", "[monitor][H-02][H-17]") {
  const auto breaches = [](int neutrals) {
    Stage stage = ready_to_move(sr::mode_1_at_rest, spm::mode_1_valid);
    stage.cycles(neutrals, sr::neutral, spm::inhibited);
    stage.cycle(sr::forward, spm::awaiting_neutral);
    stage.brakes(true);
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-12.1"));
  CHECK(breaches(5) == "");
}
