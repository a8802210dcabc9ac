// Each clause about lamps: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

Stage awake(const char* answer, const char* remote = sr::power_up) {
  Stage stage;
  stage.greet(answer, remote);
  stage.cycles(5, sr::neutral, spm::inhibited);
  return stage;
}

std::string breaches_of_answer(const char* turn, const char* answer) {
  Stage stage = awake(spm::power_up_all);
  stage.cycle(turn, answer);
  return stage.breaches();
}

}  // namespace

TEST_CASE("H-32.3, H-32.5: a lamp is lit, or told of, without lighting on both sides", "[monitor][H-32]") {
  struct Case {
    const char* power_module;
    const char* remote;
    bool is_wrong;
  };
  for (const Case& one :
       {Case{spm::power_up_all, sr::power_up, false}, Case{"05 81 F9 0F", sr::power_up, false},
        Case{spm::power_up_1, sr::power_up, true}, Case{spm::power_up_2, sr::power_up, true},
        Case{spm::power_up_all, sr::power_up_plain, true}, Case{spm::power_up_all, sr::power_up_short, true}}) {
    CAPTURE(one.power_module, one.remote);
    Stage lit = awake(one.power_module, one.remote);
    lit.pins.headlight = true;
    lit.cycle(sr::headlight, spm::ready);
    CHECK(lit.breaks("H-32.3") == one.is_wrong);
    Stage told = awake(one.power_module, one.remote);
    told.cycle(sr::headlight, spm::headlight);
    CHECK(told.breaches() == (one.is_wrong ? "H-32.5" : ""));
  }
  Stage fault = awake(spm::power_up);
  fault.cycle(sr::neutral, "61 92 80 C0 80 81 80 80 CB 0F");
  CHECK(fault.breaks("H-32.5"));
}

TEST_CASE("H-32.4: a lamp is lit that nobody asks for", "[monitor][H-32]") {
  const auto breaches = [](const char* turn, bool Pins::*pin, Time after) {
    Stage stage = awake(spm::power_up_all);
    stage.cycle(turn, spm::ready);
    stage.pins.*pin = true;
    stage.later(after, [&stage, pin] { stage.pins.*pin = false; });
    stage.cycles(6, sr::neutral, spm::cadence);
    return stage.breaches();
  };
  struct Case {
    const char* turn;
    bool Pins::*pin;
  };
  for (const Case& one : {Case{sr::left, &Pins::left_indicator}, Case{sr::right_side, &Pins::right_indicator},
                          Case{sr::hazard, &Pins::left_indicator}, Case{sr::hazard, &Pins::right_indicator}}) {
    CHECK(is_caught(breaches(one.turn, one.pin, 104ms), "H-32.4"));
    CHECK_FALSE(is_caught(breaches(one.turn, one.pin, 103ms), "H-32.4"));
  }
  CHECK(is_caught(breaches(sr::headlight, &Pins::headlight, 104ms), "H-32.4"));
  CHECK(is_caught(breaches(sr::left, &Pins::right_indicator, 50ms), "H-32.4"));
  Stage silent = awake(spm::power_up_all);
  silent.cycle(sr::headlight, spm::headlight);
  silent.pins.headlight = true;
  silent.run(500ms);
  CHECK(silent.breaches() == "");
}

TEST_CASE("H-32.6: a lamp status is told that was not asked for", "[monitor][H-32]") {
  CHECK(breaches_of_answer(sr::left, "61 92 80 C0 84 80 80 80 C8 0F") == "");
  CHECK(breaches_of_answer(sr::right_side, "61 92 80 C0 82 80 80 80 CA 0F") == "");
  CHECK(breaches_of_answer(sr::hazard, "61 92 80 C0 88 80 80 80 C4 0F") == "");
  CHECK(breaches_of_answer(sr::headlight, spm::headlight) == "");
  CHECK(is_caught(breaches_of_answer(sr::neutral, "61 92 80 C0 84 80 80 80 C8 0F"), "H-32.6"));
  CHECK(is_caught(breaches_of_answer(sr::left, "61 92 80 C0 82 80 80 80 CA 0F"), "H-32.6"));
  CHECK(is_caught(breaches_of_answer(sr::left, "61 92 80 C0 88 80 80 80 C4 0F"), "H-32.6"));
  CHECK(is_caught(breaches_of_answer(sr::left, spm::headlight), "H-32.6"));
  CHECK(is_caught(breaches_of_answer(sr::hazard, spm::hazard_and_left), "H-32.6"));
  constexpr const char* hazard_and_both = "60 C0 C0 FF C0 80 F4 80 EC 0F";  // all three are asked for
  CHECK(is_caught(breaches_of_answer(hazard_and_both, "61 92 80 C0 84 80 80 80 C8 0F"), "H-32.6"));
  CHECK(is_caught(breaches_of_answer(hazard_and_both, "61 92 80 C0 82 80 80 80 CA 0F"), "H-32.6"));
}

TEST_CASE("H-32.7: the cadence told is not that of the indicators", "[monitor][H-32]") {
  const auto breaches = [](const char* dark, const char* lit, int late) {
    Stage stage = awake(spm::power_up_all);
    stage.cycles(5, sr::left, dark);
    stage.pins.left_indicator = true;
    stage.cycles(late, sr::left, dark);
    stage.cycles(5, sr::left, lit);
    stage.pins.left_indicator = false;
    stage.cycles(late, sr::left, lit);
    stage.cycles(5, sr::left, dark);
    return stage.breaches();
  };
  constexpr const char* left_dark = "61 92 80 C0 84 80 80 80 C8 0F";
  CHECK(breaches(left_dark, spm::left, 0) == "");
  CHECK(breaches(left_dark, spm::left, 1) == "");
  CHECK(breaches(left_dark, spm::left, 3) == "H-32.7");
  CHECK(breaches(spm::left, spm::left, 0) == "H-32.7");
  CHECK(breaches(left_dark, left_dark, 0) == "H-32.7");
  CHECK(breaches(spm::left_fault, spm::left_fault, 0) == "");
}
