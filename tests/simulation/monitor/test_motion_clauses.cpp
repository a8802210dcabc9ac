// Each clause about the wheels: a trace that breaks it, and one that nearly does. A trace begins in a cycle of 20 ms
// whose general ends 2.574 ms after its begin; samples are taken at whole milliseconds.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

// At a steady 100 of 511, at the begin of a cycle.
Stage at_100() {
  Stage stage;
  stage.drive_at(100);
  return stage;
}

// Holds the duties and lets them grow by one step in the sample that comes `after`.
Stage& grow(Stage& stage, Time end) {
  stage.run_until(end - 1ms);
  stage.drive(101, 101);
  stage.run_until(end);
  return stage;
}

// The duties grow so long after the begin of a turn.
std::string breaches_of_growth(const char* turn, const char* answer, Time after) {
  Stage stage = at_100();
  const Time end = stage.now + after;
  stage.turn(turn, answer);
  return grow(stage, end).breaches();
}

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

// From rest to a small duty after so many generals at rest, which follow on whatever the stage has seen.
void set_off_after(Stage& stage, int neutrals) {
  stage.cycles(neutrals, sr::neutral, spm::limping_at_rest);
  stage.cycle(sr::forward, spm::limping);
  stage.brakes(true);
  stage.cycles(6, sr::forward, spm::limping);
  stage.drive(5, 5);
  stage.cycle(sr::forward, spm::limping);
}

constexpr const char* three_corrupt_of_sacu = "58 C0 C0 FF C0 84 80 E5 58 C0 C0 FF C0 84 80 E5 58 C0 C0 FF C0 84 80 E5";
constexpr const char* two_corrupt_of_sacu = "58 C0 C0 FF C0 84 80 E5 58 C0 C0 FF C0 84 80 E5";

}  // namespace

TEST_CASE("H-01.1: a duty grows when the last general is 62 ms old", "[monitor][H-01]") {
  Stage late = at_100();
  CHECK(grow(late, late.now + 46ms).breaks("H-01.1"));
  Stage soon = at_100();
  CHECK(grow(soon, soon.now + 45ms).breaches() == "");
}

TEST_CASE("H-01.2, H-09.1: a duty grows after the remote has started anew", "[monitor][H-01][H-09]") {
  const auto late = breaches_of_growth(sr::power_up, spm::power_up, 9ms);
  CHECK(is_caught(late, "H-01.2"));
  CHECK(is_caught(late, "H-09.1"));
  CHECK(breaches_of_growth(sr::power_up, spm::power_up, 8ms) == "");
}

TEST_CASE("H-02.1: a duty grows after too few generals at rest since power-up", "[monitor][H-02]") {
  Stage four;
  four.greet();
  set_off_after(four, 4);
  CHECK(four.breaks("H-02.1"));
  Stage five;
  five.greet();
  set_off_after(five, 5);
  CHECK(five.breaches() == "");
}

TEST_CASE("H-02.1: the edge of neutral is neutral, one count beyond it is not", "[monitor][H-02]") {
  const auto breaches = [](const char* last) {
    Stage stage;
    stage.greet();
    stage.cycles(4, sr::neutral, spm::inhibited);
    stage.cycle(last, spm::awaiting_neutral);
    set_off_after(stage, 0);
    return stage.breaches();
  };
  CHECK(breaches(sr::edge_of_neutral) == "");
  CHECK(is_caught(breaches(sr::beyond_neutral), "H-02.1"));
}

TEST_CASE("H-02.1: a duty grows after too few generals at rest since a reset", "[monitor][H-02]") {
  const auto breaches = [](int neutrals) {
    Stage stage;
    stage.wake_up();
    stage.reset();
    stage.run(1ms);
    stage.cycle(sr::power_up, spm::power_up);
    set_off_after(stage, neutrals);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-02.1"));
  CHECK(breaches(5) == "");
}

TEST_CASE("H-02.1: a duty grows after too few generals at rest since an inhibit or another mode", "[monitor][H-02]") {
  const auto breaches = [](const char* turn, const char* answer, int neutrals) {
    Stage stage;
    stage.wake_up();
    stage.cycle(turn, answer);
    set_off_after(stage, neutrals);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(sr::inhibit_at_rest, spm::inhibited, 4), "H-02.1"));
  CHECK(breaches(sr::inhibit_at_rest, spm::inhibited, 5) == "");
  CHECK(is_caught(breaches(sr::mode_4, spm::mode_4_invalid, 4), "H-02.1"));
  CHECK(breaches(sr::mode_4, spm::mode_4_invalid, 5) == "");
}

TEST_CASE("H-02.1: after silence five generals bring the link back, and neutral is counted from the fifth on",
          "[monitor][H-02][H-08]") {
  const auto breaches = [](int neutrals) {
    Stage stage;
    stage.wake_up();
    stage.run(100ms);
    set_off_after(stage, neutrals);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(8), "H-02.1"));
  CHECK(breaches(9) == "");
}

TEST_CASE("H-03.1: the chair gathers speed though the stick is at rest", "[monitor][H-03]") {
  const auto breaches = [](int grown_to) {
    Stage stage = at_100();
    stage.drive(0, 0);
    stage.later(8ms + 500us, [&] { stage.drive(grown_to, grown_to); });
    stage.cycle(sr::neutral, spm::ready);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(93), "H-03.1"));  // down to 92 at first
  CHECK(breaches(92) == "");
}

TEST_CASE("H-03.1: the inner wheel of a turn that ends does not come up to the outer one", "[monitor][H-03]") {
  const auto breaches = [](int inner) {
    Stage stage = at_100();
    stage.drive(100, 60);
    stage.cycles(2, sr::forward, spm::driving);
    stage.drive(0, 0);
    stage.later(8ms + 500us, [&] { stage.drive(90, inner); });
    stage.cycle(sr::neutral, spm::ready);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(60), "H-03.1"));
}

TEST_CASE("H-03.2: with the stick at rest the duties fall too slowly", "[monitor][H-03]") {
  Stage late = at_100();
  late.cycle(sr::neutral, spm::ready);
  CHECK(late.breaks("H-03.2"));  // 100 for 20 ms
  Stage soon = at_100();
  const Time end = soon.now + 19ms;
  soon.turn(sr::neutral, spm::ready);
  soon.run_until(end);
  CHECK(soon.breaches() == "");
}

TEST_CASE("H-03.2: the duties fall well at first and then stay", "[monitor][H-03]") {
  Stage stage;
  stage.drive_at(400);
  stage.later(4ms, [&] { stage.drive(300, 300); });
  stage.cycles(31, sr::neutral, spm::ready);
  const Time begin = stage.now;
  stage.turn(sr::neutral, spm::ready);
  stage.run_until(begin + 11ms);
  CHECK(stage.breaches() == "");
  stage.run_until(begin + 12ms);  // the line meets 298 at 631.4 ms
  CHECK(stage.breaks("H-03.2"));
}

TEST_CASE("H-04.1: a duty grows 5 ms after silence, though a general has come again", "[monitor][H-04]") {
  const auto breaches = [](Time after) {
    Stage stage = at_100();
    const Time end = stage.now + after;
    stage.run(43ms);  // the next general ends 65.6 ms after the last
    stage.turn(sr::forward, "");
    return grow(stage, end).breaches();
  };
  CHECK(is_caught(breaches(51ms), "H-04.1"));
  CHECK(breaches(50ms) == "");
}

TEST_CASE("H-04.1: a general in time keeps the chair going", "[monitor][H-04]") {
  Stage stage = at_100();
  stage.run(39ms);  // the next general ends 61.6 ms after the last
  stage.turn(sr::forward, spm::driving);
  grow(stage, stage.now + 20ms);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-04.2: an emergency stop is too slow", "[monitor][H-04]") {
  Stage late = at_100();
  late.run(56ms);
  CHECK(late.breaks("H-04.2"));
  Stage soon = at_100();
  soon.run(55ms);
  CHECK(soon.breaches() == "");
}

TEST_CASE("H-04.2: an emergency stop begins well and then stays", "[monitor][H-04]") {
  Stage stage;
  stage.drive_at(400);
  const Time begin = stage.now;
  stage.later(46ms, [&] { stage.drive(100, 100); });
  stage.run_until(begin + 936ms);
  CHECK(stage.breaches() == "");
  stage.run_until(begin + 937ms);  // the line meets 98 at 936.1 ms
  CHECK(stage.breaks("H-04.2"));
}

TEST_CASE("H-05.1: a duty grows 5 ms after the third corrupt packet in a row", "[monitor][H-05]") {
  const auto breaches = [](const char* bytes, Time after) {
    Stage stage = at_100();
    const Time end = stage.now + after;
    stage.says(Sender::sacu, bytes);
    return grow(stage, end).breaches();
  };
  CHECK(is_caught(breaches(three_corrupt_of_sacu, 13ms), "H-05.1"));
  CHECK(breaches(three_corrupt_of_sacu, 12ms) == "");
  CHECK(breaches(two_corrupt_of_sacu, 13ms) == "");
}

TEST_CASE("H-05.1: an unknown packet with a right checksum ends a run of corrupt ones", "[monitor][H-05]") {
  Stage stage = at_100();
  stage.says(Sender::sacu, two_corrupt_of_sacu);
  stage.says(Sender::sacu, "0B 80 F4");
  stage.says(Sender::sacu, "58 C0 C0 FF C0 84 80 E5");
  grow(stage, stage.now + 20ms);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-07.3: more than 41 % while limping", "[monitor][H-07]") {
  const auto breaches = [](const char* turn, const char* answer, int duty) {
    Stage stage;
    stage.drive_at(240);
    stage.drive(duty, duty);
    stage.cycles(76, turn, answer);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(sr::pot_error, spm::limping, 210), "H-07.3"));
  CHECK(breaches(sr::pot_error, spm::limping, 209) == "");
  CHECK(is_caught(breaches(sr::non_critical, spm::limping_for_remote, 210), "H-07.3"));
  CHECK(breaches(sr::non_critical, spm::limping_for_remote, 209) == "");
}

TEST_CASE("H-07.3: LIMP's cap must be reached 1500 ms after its cause", "[monitor][H-07]") {
  const auto breaches = [](Time after) {
    Stage stage;
    stage.drive_at(240);
    stage.drive(210, 210);
    stage.later(after, [&] { stage.drive(209, 209); });
    stage.cycles(76, sr::pot_error, spm::limping);  // the first ends at 2.6 ms
    return stage.breaches();
  };
  CHECK(is_caught(breaches(1504ms), "H-07.3"));
  CHECK(breaches(1503ms) == "");
}

TEST_CASE("H-11.1: a duty changes its sign at once", "[monitor][H-11]") {
  const auto breaches = [](int from, int to) {
    Stage stage;
    stage.set_off();
    stage.drive(from, from);
    stage.cycle(sr::forward, spm::driving);
    stage.jump(to, to);
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(5, -4), "H-11.1"));
  CHECK(breaches(4, -4) == "");
}

TEST_CASE("H-11.2: the chair goes backward with the stick forward", "[monitor][H-11]") {
  const auto breaches = [](int duty) {
    Stage stage;
    stage.set_off();
    stage.drive(duty, duty);
    stage.cycle(sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(-5), "H-11.2"));
  CHECK(breaches(-4) == "");
}

TEST_CASE("H-11.2: a stick pulled round first ends the other way", "[monitor][H-11]") {
  Stage stage;
  stage.drive_at(-100);
  stage.drive(20, 20);
  stage.cycles(7, sr::forward, spm::driving);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-11.3: the chair turns left with the stick to the right", "[monitor][H-11]") {
  const auto breaches = [](int left, int right) {
    Stage stage;
    stage.set_off(sr::right);
    stage.drive(left, right);
    stage.cycle(sr::right, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(-5, 5), "H-11.3"));
  CHECK(breaches(-4, 4) == "");
  CHECK(breaches(20, -20) == "");
}

TEST_CASE("H-16.4: a duty grows after a press of the button was accepted", "[monitor][H-16]") {
  const auto breaches = [](Time after) {
    Stage stage = at_100();
    const Time end = stage.now + after;
    stage.cycles(3, sr::button, spm::driving);
    stage.turn(sr::button, spm::driving);
    return grow(stage, end).breaches();
  };
  CHECK(is_caught(breaches(69ms), "H-16.4"));
  CHECK(breaches(68ms) == "");
}

TEST_CASE("H-16.4: a press is certain after 52 ms", "[monitor][H-16]") {
  const auto breaches = [](Time held) {
    Stage stage = at_100();
    const Time begin = stage.now;
    stage.turn(sr::button, spm::driving);
    stage.run_until(begin + held);
    stage.turn(sr::button, spm::driving);
    return grow(stage, begin + held + 9ms).breaches();
  };
  CHECK(is_caught(breaches(52ms), "H-16.4"));
  CHECK(breaches(51ms) == "");
}

TEST_CASE("H-17.4: a duty grows though another mode is requested", "[monitor][H-17]") {
  CHECK(is_caught(breaches_of_growth(sr::mode_1, spm::mode_1_invalid, 9ms), "H-17.4"));
  CHECK(breaches_of_growth(sr::mode_1, spm::mode_1_invalid, 8ms) == "");
}

TEST_CASE("H-19.1 to H-19.4: a duty grows under an inhibit", "[monitor][H-19]") {
  struct Case {
    const char* clause;
    const char* turn;
  };
  for (const Case& one :
       {Case{"H-19.1", sr::remote_inhibit}, Case{"H-19.2", sr::charger_inhibit}, Case{"H-19.3", sr::joystick_error},
        Case{"H-19.3", sr::local_fault}, Case{"H-19.4", sr::calibration}}) {
    CAPTURE(one.clause, one.turn);
    CHECK(is_caught(breaches_of_growth(one.turn, spm::awaiting_neutral, 9ms), one.clause));
    CHECK(breaches_of_growth(one.turn, spm::awaiting_neutral, 8ms) == "");
  }
}

TEST_CASE("H-19.5: a stop for an inhibit is too slow", "[monitor][H-19]") {
  const auto breaches = [](Time after) {
    Stage stage = at_100();
    const Time end = stage.now + after;
    stage.turn(sr::remote_inhibit, spm::awaiting_neutral);
    stage.run_until(end);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(14ms), "H-19.5"));
  CHECK(breaches(13ms) == "");
}

TEST_CASE("H-33.1: a duty jumps up", "[monitor][H-33]") {
  const auto breaches = [](int step) {
    Stage stage = at_100();
    stage.drive(100 + step, 100 + step, step);
    stage.cycle(sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(10), "H-33.1"));
  CHECK(breaches(9) == "");
}

TEST_CASE("H-33.1: a duty rises too fast by small steps", "[monitor][H-33]") {
  const auto breaches = [](int step) {
    Stage stage = at_100();
    stage.drive(160, 160, step);
    stage.cycles(2, sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(3), "H-33.1"));
  CHECK(breaches(2) == "");
}

TEST_CASE("H-33.2: a duty falls at once", "[monitor][H-33]") {
  const auto breaches = [](int step) {
    Stage stage = at_100();
    stage.drive(100 - step, 100 - step, step);
    stage.cycle(sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(10), "H-33.2"));
  CHECK(breaches(9) == "");
}

TEST_CASE("H-12.3: bridge and relay may go at once, but not without the brakes", "[monitor][H-12][H-33]") {
  Stage stage = at_100();
  stage.jump(0, 0);
  stage.pins.bridge_enable = stage.pins.motor_relay = false;
  stage.cycle(sr::forward, spm::ready);
  CHECK(stage.breaks("H-12.3"));
  CHECK_FALSE(stage.breaks("H-33.2"));
}

TEST_CASE("H-33.2: all may go off together", "[monitor][H-33]") {
  Stage stage = at_100();
  stage.jump(0, 0);
  stage.brakes(false);
  stage.cycle(sr::forward, spm::ready);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-33.2: a duty may fall at once while it drives too much current, and shortly after",
          "[monitor][H-33][H-31]") {
  const auto breaches = [](double current, Time after) {
    Stage stage = at_100();
    stage.currents(current, 0);
    stage.run(1ms);
    stage.currents(0, 0);
    stage.later(after, [&] { stage.jump(60, 100); });
    stage.cycles(2, sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(breaches(61, 20ms) == "");
  CHECK(is_caught(breaches(61, 30ms), "H-33.2"));
  CHECK(is_caught(breaches(59, 1ms), "H-33.2"));
  CHECK(is_caught(breaches(-61, 1ms), "H-33.2"));  // that motor brakes
}

TEST_CASE("H-11.3: a wheel that is cut may turn the chair, but not when its current is gone", "[monitor][H-11][H-31]") {
  const auto breaches = [](double current) {
    Stage stage;
    stage.set_off(sr::right);
    stage.drive(20, 0);
    stage.cycles(2, sr::right, spm::driving);
    stage.currents(current, 0);
    stage.run(1ms);
    stage.jump(12, 0);
    stage.run(1ms);
    stage.drive(12, 24, 2);
    stage.cycles(1, sr::right, spm::driving);
    return stage.breaches();
  };
  CHECK(breaches(70) == "");
  CHECK(is_caught(breaches(20), "H-11.3"));
}

TEST_CASE("H-31.1: more than 80 A for more than 60 ms", "[monitor][H-31]") {
  const auto breaches = [](double left, double right, Time span) {
    Stage stage = at_100();
    stage.later(1ms, [&] { stage.currents(left, right); });
    stage.later(1ms + span, [&] { stage.currents(0, 0); });
    stage.cycles(6, sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(breaches(81, 0, 60ms) == "");
  CHECK(is_caught(breaches(81, 0, 61ms), "H-31.1"));
  CHECK(is_caught(breaches(0, -81, 61ms), "H-31.1"));
  CHECK(breaches(80, -80, 100ms) == "");
}

TEST_CASE("H-31.2: a duty grows while its motor has more than its peak current", "[monitor][H-31]") {
  const auto breaches = [](double left, Time after) {
    Stage stage = at_100();
    stage.later(1ms, [&] { stage.currents(left, 0); });
    stage.later(1ms + after, [&] { stage.drive(102, 102); });
    stage.cycles(3, sr::forward, spm::driving);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(63, 25ms), "H-31.2"));
  CHECK(breaches(63, 22ms) == "");
  CHECK(breaches(62, 30ms) == "");
  CHECK(breaches(-63, 30ms) == "");  // it brakes
}
