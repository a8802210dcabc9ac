// Each clause about the power latch: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

// The latch is let go so long after the end of a cycle; the last general is 17.4 ms old then.
std::string breaches_of_letting_go(Stage& stage, Time after, Time watched) {
  stage.later(after, [&] { stage.pins.power_latch = false; });
  stage.run(watched);
  return stage.breaches();
}

void ask_for_power_down(Stage& stage) {
  stage.wake_up();
  stage.cycles(4, sr::button_at_rest, spm::inhibited);
  stage.cycle(sr::neutral, spm::power_down_now);
}

}  // namespace

TEST_CASE("H-04.4, H-16.2: the latch is let go too late or too early after the last general", "[monitor][H-04][H-16]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.wake_up();
    return breaches_of_letting_go(stage, after, 5100ms);
  };
  CHECK(is_caught(breaches(4962ms), "H-16.2"));
  CHECK(breaches(4963ms) == "");
  CHECK(breaches(5002ms) == "");
  CHECK(is_caught(breaches(5004ms), "H-04.4"));
}

TEST_CASE("H-04.4, H-16.2: with power down now half a second is enough", "[monitor][H-04][H-16]") {
  const auto breaches = [](Time after) {
    Stage stage;
    ask_for_power_down(stage);
    return breaches_of_letting_go(stage, after, 600ms);
  };
  CHECK(is_caught(breaches(462ms), "H-16.2"));
  CHECK(breaches(463ms) == "");
  CHECK(breaches(502ms) == "");
  CHECK(is_caught(breaches(504ms), "H-04.4"));
}

TEST_CASE("H-14.1: the latch is let go while a brake is released or a duty is left", "[monitor][H-14]") {
  const auto breaches = [](bool is_braked) {
    Stage stage;
    stage.set_off();
    stage.later(60ms, [&, is_braked] { stage.brakes(!is_braked); });
    return breaches_of_letting_go(stage, 4970ms, 4970ms);
  };
  CHECK(is_caught(breaches(false), "H-14.1"));
  CHECK(breaches(true) == "");
}

TEST_CASE("H-15.1: the latch comes too late after power or reset", "[monitor][H-15]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.power(true);
    stage.later(after, [&] { stage.pins.power_latch = true; });
    stage.run(40ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(22ms), "H-15.1"));
  CHECK(breaches(21ms) == "");
  Stage stage;
  stage.wake_up();
  stage.reset();
  stage.pins.power_latch = false;
  stage.run(30ms);
  CHECK(stage.breaches() == "H-15.1");
}

TEST_CASE("H-16.2: the latch is let go without two confirms of what was asked", "[monitor][H-16]") {
  const auto breaches = [](int confirms, bool is_asked) {
    Stage stage;
    if (is_asked) {
      ask_for_power_down(stage);
    } else {
      stage.wake_up();
    }
    stage.cycles(confirms, sr::confirm, is_asked ? spm::power_down_now : spm::ready);
    return breaches_of_letting_go(stage, 1ms, 2ms);
  };
  CHECK(is_caught(breaches(1, true), "H-16.2"));
  CHECK(breaches(2, true) == "");
  CHECK(is_caught(breaches(10, false), "H-16.2"));
}

TEST_CASE("H-16.2: a module that never spoke may let go after 5 s, whoever calls it, and not sooner",
          "[monitor][H-16]") {
  const auto breaches = [](Time after, bool speaks) {
    Stage stage;
    stage.power(true);
    stage.pins.power_latch = true;
    stage.later(after, [&] { stage.pins.power_latch = false; });
    for (int i = 0; i < 252; ++i) {
      stage.cycle(sr::power_up, i == 0 && speaks ? spm::power_up : "");
    }
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4979ms, false), "H-16.2"));
  CHECK(breaches(4981ms, false) == "");
  CHECK(is_caught(breaches(4981ms, true), "H-16.2"));
}

TEST_CASE("H-16.2: two confirms must follow each other", "[monitor][H-16]") {
  Stage stage;
  ask_for_power_down(stage);
  stage.cycle(sr::confirm, spm::power_down_now);
  stage.cycle(sr::neutral, spm::power_down_now);
  stage.cycle(sr::confirm, spm::power_down_now);
  CHECK(is_caught(breaches_of_letting_go(stage, 1ms, 2ms), "H-16.2"));
}

TEST_CASE("H-16.3: the latch is still held though power-down was confirmed", "[monitor][H-16]") {
  const auto breaches = [](Time after) {
    Stage stage;
    ask_for_power_down(stage);
    stage.cycles(1, sr::confirm, spm::power_down_now);
    stage.later(after, [&] { stage.pins.power_latch = false; });
    stage.cycles(13, sr::confirm, spm::power_down_now);  // the first is the second confirm, at 2.6 ms
    return stage.breaches();
  };
  CHECK(is_caught(breaches(204ms), "H-16.3"));
  CHECK(breaches(203ms) == "");
}
