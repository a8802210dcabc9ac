// Each clause about what the power module tells: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "simulation/monitor/limits.hpp"
#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

struct Exchange {
  const char* turn;
  const char* answer;
  int times = 1;
};

// After power-up and neutral.
std::string breaches_of(const std::vector<Exchange>& exchanges, const char* power_up = spm::power_up_all) {
  Stage stage;
  stage.wake_up(power_up);
  for (const Exchange& exchange : exchanges) {
    stage.cycles(exchange.times, exchange.turn, exchange.answer);
  }
  return stage.breaches();
}

}  // namespace

TEST_CASE("H-02.2: the remote is not told that its stick must come to rest", "[monitor][H-02]") {
  const auto breaches = [](const char* turn, const char* answer) {
    Stage stage;
    stage.greet();
    stage.cycle(turn, answer);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(sr::forward, spm::inhibited), "H-02.2"));
  CHECK(breaches(sr::forward, spm::awaiting_neutral) == "");
  CHECK(breaches(sr::neutral, spm::inhibited) == "");
}

TEST_CASE("H-06.1: one general without the remote's non-critical fault, or four, end its LIMP", "[monitor][H-06]") {
  for (const int clean : {1, 4}) {
    CHECK(is_caught(breaches_of({{sr::non_critical, spm::limping_for_remote, 5},
                                 {sr::forward, spm::limping_for_remote, clean - 1},
                                 {sr::forward, spm::driving}}),
                    "H-06.1"));
  }
  CHECK(breaches_of({{sr::non_critical, spm::limping_for_remote, 5},
                     {sr::forward, spm::limping_for_remote, 4},
                     {sr::forward, spm::driving, 5}}) == "");
}

TEST_CASE("H-07.1: LIMP is not told after its cause", "[monitor][H-07]") {
  CHECK(is_caught(breaches_of({{sr::pot_error, spm::driving, 3}}), "H-07.1"));
  CHECK(breaches_of({{sr::pot_error, spm::driving, 2}, {sr::forward, spm::limping, 50}}) == "");
  Stage stage;
  stage.wake_up();
  stage.run(100ms);  // silence
  stage.cycles(3, sr::neutral, spm::awaiting_neutral);
  CHECK(stage.breaks("H-07.1"));
}

TEST_CASE("H-07.2: LIMP is taken back", "[monitor][H-07]") {
  CHECK(is_caught(breaches_of({{sr::forward, spm::limping}, {sr::forward, spm::driving}}), "H-07.2"));
  CHECK(breaches_of({{sr::non_critical, spm::limping_for_remote, 5},
                     {sr::forward, spm::limping_for_remote, 6},
                     {sr::forward, spm::driving, 5}}) == "");
  CHECK(is_caught(breaches_of({{sr::non_critical, spm::limping_for_remote, 5},
                               {sr::forward, spm::limping_for_remote, 7},
                               {sr::forward, spm::driving}}),
                  "H-07.2"));
}

TEST_CASE("H-16.1: power down now is told without a press, during it, or after bounce", "[monitor][H-16]") {
  CHECK(is_caught(breaches_of({{sr::neutral, spm::power_down_now}}), "H-16.1"));
  CHECK(is_caught(breaches_of({{sr::button_at_rest, spm::inhibited, 4}, {sr::button_at_rest, spm::power_down_now}}),
                  "H-16.1"));
  CHECK(is_caught(breaches_of({{sr::button_at_rest, spm::ready, 3}, {sr::neutral, spm::power_down_now}}), "H-16.1"));
  CHECK(breaches_of({{sr::button_at_rest, spm::inhibited, 4}, {sr::neutral, spm::power_down_now, 5}}) == "");
}

TEST_CASE("H-16.1: a press is possible after 48 ms", "[monitor][H-16]") {
  const auto breaches = [](Time held) {
    Stage stage;
    stage.wake_up();
    const Time begin = stage.now;
    stage.turn(sr::button_at_rest, spm::ready);
    stage.run_until(begin + held);
    stage.cycle(sr::button_at_rest, spm::ready);
    stage.cycle(sr::neutral, spm::power_down_now);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(47ms), "H-16.1"));
  CHECK(breaches(48ms) == "");
}

TEST_CASE("H-16.1: a button that is down at power-up is no press before its release", "[monitor][H-16]") {
  Stage stage;
  stage.greet();
  stage.cycles(10, sr::button_at_rest, spm::inhibited);
  stage.cycle(sr::neutral, spm::power_down_now);
  CHECK(stage.breaks("H-16.1"));
}

TEST_CASE("H-16.1: sleep may be told after 15 minutes at rest", "[monitor][H-16]") {
  CHECK(is_caught(breaches_of({{sr::neutral, spm::sleep}}), "H-16.1"));
  simulation::monitor::Supply supply;
  supply.begin_anew(0s);
  CHECK_FALSE(supply.may_sleep(15min - 2s));
  CHECK(supply.may_sleep(15min));
}

TEST_CASE("H-17.2: another mode is told than was requested", "[monitor][H-17]") {
  CHECK(is_caught(breaches_of({{sr::mode_1, spm::awaiting_neutral}}), "H-17.2"));
  CHECK(breaches_of({{sr::mode_1, spm::mode_1_invalid}}) == "");
  CHECK(is_caught(breaches_of({{sr::neutral, spm::mode_1_invalid}}), "H-17.2"));
}

TEST_CASE("H-17.3: mode invalid is told where it must not be, or not where it must", "[monitor][H-17]") {
  CHECK(is_caught(breaches_of({{sr::neutral, "61 92 80 C0 80 80 90 80 BC 0F"}}), "H-17.3"));
  CHECK(is_caught(breaches_of({{sr::mode_1, spm::mode_1}, {sr::mode_1, spm::mode_1_invalid}}), "H-17.3"));
  CHECK(is_caught(breaches_of({{sr::mode_4, spm::mode_4}}), "H-17.3"));
  CHECK(breaches_of({{sr::mode_1, spm::mode_1_invalid, 2}, {sr::mode_1, spm::mode_1, 3}}) == "");
  CHECK(breaches_of(
            {{sr::mode_1, spm::mode_1}, {sr::mode_4, spm::mode_4_invalid}, {sr::mode_1, spm::mode_1_invalid}}) == "");
}

TEST_CASE("H-19.7: a duty grows though it is told that driving is inhibited", "[monitor][H-19]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.drive_at(100);
    const Time end = stage.now + after;
    stage.turn(sr::forward, spm::inhibited);  // told after 5.5 ms
    stage.run_until(end - 1ms);
    stage.drive(101, 101);
    stage.run_until(end);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(12ms), "H-19.7"));
  CHECK(breaches(11ms) == "");
}

TEST_CASE("H-19.8: it is not told that driving is inhibited", "[monitor][H-19]") {
  CHECK(is_caught(breaches_of({{sr::inhibit_at_rest, spm::ready, 3}}), "H-19.8"));
  CHECK(breaches_of({{sr::inhibit_at_rest, spm::ready, 2}, {sr::inhibit_at_rest, spm::inhibited}}) == "");
  Stage stage;
  stage.greet();
  stage.cycle(sr::neutral, spm::ready);
  CHECK(stage.breaks("H-19.8"));
}

TEST_CASE("H-32.2: an old remote is told of lamps", "[monitor][H-32]") {
  constexpr const char* left_indicator = "61 92 80 C0 84 80 80 80 C8 0F";
  CHECK(is_caught(breaches_of({{sr::old_neutral, spm::ready, 2}, {sr::old_neutral, left_indicator}}), "H-32.2"));
  CHECK_FALSE(is_caught(breaches_of({{sr::old_neutral, left_indicator}, {sr::old_neutral, spm::ready, 5}}), "H-32.2"));
  CHECK(breaches_of({{sr::left, left_indicator, 5}}) == "");
}
