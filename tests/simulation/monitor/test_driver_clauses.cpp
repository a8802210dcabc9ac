// Each clause about who drives: a trace that breaks it, and one that nearly does. The attendant control's general ends
// 8.152 ms after the begin of a cycle, the power module's 5.478 ms.
#include <catch2/catch.hpp>

#include <utility>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

Stage attended(const char* power_up = sacu::power_up) {
  Stage stage;
  stage.wake_up(spm::power_up_all);
  stage.meet_attendant(power_up);
  stage.hand_over();
  return stage;
}

// The attendant control drives, both duties at 100.
Stage attended_at_100(const char* power_up = sacu::power_up) {
  Stage stage = attended(power_up);
  stage.attend_at_100();
  return stage;
}

// The remote drives, and the attendant control stands by.
Stage accompanied_at_100() {
  Stage stage;
  stage.wake_up();
  stage.meet_attendant();
  stage.trio(sr::forward, spm::ready, sacu::standing_by);
  stage.brakes(true);
  stage.trios(6, sr::forward, spm::driving, sacu::standing_by);
  stage.drive(100, 100);
  stage.trios(7, sr::forward, spm::driving, sacu::standing_by);
  return stage;
}

// One more cycle, and the duties grow by a step in the sample that comes so long after its begin.
std::string breaches_of_growth(Stage stage, const char* remote, const char* answer, const char* attendant, Time after) {
  const Time begin = stage.now;
  stage.later(after, [&] { stage.drive(101, 101); });
  stage.turn(remote, answer);
  stage.run(100us);
  stage.says(Sender::sacu, attendant);
  stage.run_until(begin + after);
  return stage.breaches();
}

}  // namespace

TEST_CASE("an attendant control drives, and breaks nothing", "[monitor][negotiation]") {
  Stage stage = attended_at_100();
  stage.trios(10, sr::neutral, spm::attendant_driving, sacu::forward);
  CHECK(stage.breaches() == "");
  Stage other = accompanied_at_100();
  other.trios(10, sr::forward, spm::driving, sacu::standing_by_forward);
  CHECK(other.breaches() == "");
}

TEST_CASE("H-01.1, H-04.5: a duty grows though the driving attendant control is silent", "[monitor][H-01][H-04]") {
  const auto breaches = [](Time after) {
    Stage stage = attended_at_100();  // its last general ended 11.8 ms ago
    stage.later(after, [&] { stage.drive(101, 101); });
    stage.cycles(3, sr::neutral, spm::attendant_driving);
    return stage.breaches();
  };
  CHECK(breaches(51ms) == "");
  CHECK(is_caught(breaches(52ms), "H-01.1"));
  CHECK_FALSE(is_caught(breaches(56ms), "H-04.5"));
  CHECK(is_caught(breaches(57ms), "H-04.5"));
}

TEST_CASE("H-01.1: a duty grows without the remote, though the attendant control goes on", "[monitor][H-01]") {
  const auto breaches = [](Time after) {
    Stage stage = attended_at_100();  // the remote's last general ended 17.4 ms ago
    const Time end = stage.now + after;
    stage.later(after, [&] { stage.drive(101, 101); });
    stage.says(Sender::sacu, sacu::forward);
    stage.run(20ms);
    stage.says(Sender::sacu, sacu::forward);
    stage.run_until(end);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(46ms), "H-01.1"));
  CHECK(breaches(45ms) == "");
}

TEST_CASE("H-04.5: five generals of the attendant control and a stand end its silence", "[monitor][H-04][H-08]") {
  const auto breaches = [](int generals) {
    Stage stage = attended();
    stage.cycles(4, sr::neutral, spm::attendant_limping);
    stage.trios(generals, sr::neutral, spm::attendant_limping, sacu::neutral);
    stage.trio(sr::neutral, spm::attendant_limping, sacu::forward);
    stage.brakes(true);
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(8), "H-12.1"));
  CHECK(breaches(9) == "");
}

TEST_CASE("H-07.1: the silence of a driving attendant control is a cause of LIMP, one that stands by is none",
          "[monitor][H-07]") {
  Stage stage = attended();
  stage.cycles(6, sr::neutral, spm::attendant_inhibited);
  CHECK(stage.breaks("H-07.1"));
  Stage other;
  other.wake_up();
  other.meet_attendant();
  other.cycles(6, sr::neutral, spm::ready);
  CHECK(other.breaches() == "");
}

TEST_CASE("H-07.1: a pot error counts of an attendant control that drives with a pot of its own", "[monitor][H-07]") {
  const auto breaches = [](const char* power_up) {
    Stage stage = attended_at_100(power_up);
    stage.trios(3, sr::neutral, spm::attendant_driving, sacu::pot_error);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(sacu::power_up_all), "H-07.1"));
  CHECK(breaches(sacu::power_up) == "");
}

TEST_CASE("H-06.1: LIMP while an attendant control sets its non-critical fault", "[monitor][H-06]") {
  const auto breaches = [](const char* answer, int last) {
    Stage stage;
    stage.wake_up();
    stage.meet_attendant();
    stage.trios(2, sr::neutral, spm::ready, sacu::non_critical);
    stage.trios(last, sr::neutral, answer, sacu::non_critical);
    stage.trio(sr::neutral, answer, sacu::standing_by);
    stage.trios(5, sr::neutral, spm::ready, sacu::standing_by);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(spm::ready, 1), "H-06.1"));
  CHECK(breaches(spm::limping_still, 10) == "");
}

TEST_CASE("H-02.1: the new driver's stick must be seen at rest in five generals", "[monitor][H-02]") {
  const auto breaches = [](int neutrals) {
    Stage stage;
    stage.wake_up();
    stage.meet_attendant();
    stage.trio(sr::neutral, spm::ready, sacu::neutral);
    stage.trios(neutrals - 1, sr::neutral, spm::attendant_inhibited, sacu::neutral);
    stage.trio(sr::neutral, spm::attendant_awaiting, sacu::forward);
    stage.brakes(true);
    stage.trios(6, sr::neutral, spm::attendant_driving, sacu::forward);
    stage.drive(5, 5);
    stage.trio(sr::neutral, spm::attendant_driving, sacu::forward);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-02.1"));
  CHECK(breaches(5) == "");
}

TEST_CASE("H-02.2: the new driver is told that its stick must come to rest", "[monitor][H-02]") {
  const auto breaches = [](const char* answer) {
    Stage stage;
    stage.wake_up();
    stage.meet_attendant();
    stage.trio(sr::neutral, spm::ready, sacu::forward);
    stage.trio(sr::neutral, spm::attendant_inhibited, sacu::forward);
    stage.trios(2, sr::neutral, answer, sacu::forward);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(spm::attendant_inhibited), "H-02.2"));
  CHECK(breaches(spm::attendant_awaiting) == "");
}

TEST_CASE("H-02.3: it is told to the other module", "[monitor][H-02]") {
  Stage stage = attended();
  stage.trio(sr::neutral, spm::attendant_awaiting_wrong, sacu::neutral);
  CHECK(stage.breaks("H-02.3"));
  Stage other;
  other.wake_up();
  other.cycle(sr::neutral, spm::awaiting_attendant_wrong);
  CHECK(other.breaks("H-02.3"));
  Stage right = attended();
  right.trio(sr::neutral, spm::attendant_awaiting, sacu::neutral);
  CHECK(right.breaches() == "");
}

TEST_CASE("H-02.4: a duty grows in a hand-over, either way", "[monitor][H-02]") {
  const auto there = [](Time after) {
    return breaches_of_growth(accompanied_at_100(), sr::forward, spm::driving, sacu::forward, after);
  };
  CHECK(is_caught(there(15ms), "H-02.4"));
  CHECK(there(14ms) == "");
  const auto back = [](Time after) {
    return breaches_of_growth(attended_at_100(), sr::forward, spm::attendant_driving, sacu::standing_by, after);
  };
  CHECK(is_caught(back(15ms), "H-02.4"));
  CHECK(back(14ms) == "");
}

TEST_CASE("H-03.1, H-11.2: only the driver's stick counts", "[monitor][H-03][H-11]") {
  Stage stage = attended_at_100();
  stage.drive(60, 60);
  stage.trios(3, sr::neutral, spm::attendant_driving, sacu::forward);
  stage.later(15ms, [&] { stage.drive(90, 90); });
  stage.trios(2, sr::backward, spm::attendant_driving, sacu::forward);
  CHECK(stage.breaches() == "");
  stage.drive(60, 60);
  stage.trios(1, sr::forward, spm::attendant_driving, sacu::neutral);
  stage.later(1ms, [&] { stage.drive(90, 90); });
  stage.trios(1, sr::forward, spm::attendant_driving, sacu::neutral);
  CHECK(stage.breaks("H-03.1"));
  Stage other = attended_at_100();
  other.drive(0, 0);
  other.trios(10, sr::forward, spm::attendant_driving, sacu::backward);
  other.drive(20, 20);
  other.trios(1, sr::forward, spm::attendant_driving, sacu::backward);
  CHECK(other.breaks("H-11.2"));
}

TEST_CASE("H-09.3: a duty grows after the driving attendant control has started anew", "[monitor][H-09]") {
  const auto breaches = [](Time after) {
    return breaches_of_growth(attended_at_100(), sr::neutral, spm::attendant_driving, sacu::power_up, after);
  };  // 9 + 1 characters: it ends 8.438 ms after the begin
  CHECK(is_caught(breaches(15ms), "H-09.3"));
  CHECK(breaches(14ms) == "");
}

TEST_CASE("H-09.3: one that stands by may start anew", "[monitor][H-09]") {
  Stage stage = accompanied_at_100();
  stage.trio(sr::forward, spm::driving, sacu::power_up);
  stage.drive(110, 110);
  stage.trio(sr::forward, spm::driving, sacu::standing_by);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-17.5: another driver is told", "[monitor][H-17]") {
  Stage stage;
  stage.wake_up();
  stage.cycle(sr::neutral, spm::attendant);
  CHECK(stage.breaks("H-17.5"));
  Stage late;
  late.wake_up();
  late.meet_attendant();
  late.trios(2, sr::neutral, spm::ready, sacu::neutral);
  CHECK(late.breaches() == "");
  late.trio(sr::neutral, spm::ready, sacu::neutral);
  CHECK(late.breaks("H-17.5"));
  Stage silent = attended();
  silent.cycles(6, sr::neutral, spm::attendant_limping);
  CHECK(silent.breaches() == "");
  silent.cycle(sr::neutral, spm::limping_at_rest);
  CHECK(silent.breaks("H-17.5"));
}

TEST_CASE("H-17.5: generals count only after the acknowledgement", "[monitor][H-17]") {
  Stage stage;
  stage.wake_up();
  stage.trio(sr::neutral, spm::ready, sacu::power_up);
  stage.trios(3, sr::neutral, spm::ready, sacu::forward);
  CHECK(stage.breaches() == "");
  stage.trio(sr::neutral, spm::attendant, sacu::forward);
  CHECK(stage.breaks("H-17.5"));
}

TEST_CASE("H-17.5: a remote that starts anew makes the attendant control a stranger", "[monitor][H-17]") {
  Stage stage = attended();
  stage.cycle(sr::power_up, spm::power_up);
  stage.trios(3, sr::neutral, spm::limping_at_rest, sacu::neutral);
  CHECK(stage.breaches() == "");
  stage.trio(sr::neutral, spm::attendant_limping, sacu::neutral);
  CHECK(stage.breaks("H-17.5"));
}

TEST_CASE("H-17.6: an acknowledgement without a cause, for too long, or taken back", "[monitor][H-17]") {
  Stage stage;
  stage.wake_up();
  stage.cycle(sr::neutral, spm::acknowledging);
  CHECK(stage.breaks("H-17.6"));
  Stage strange;
  strange.wake_up();
  strange.trio(sr::neutral, spm::ready, sacu::neutral);
  strange.cycle(sr::neutral, spm::acknowledging);
  CHECK(strange.breaks("H-17.6"));
  Stage longer;
  longer.wake_up();
  longer.trio(sr::neutral, spm::ready, sacu::power_up);
  longer.cycles(4, sr::neutral, spm::acknowledging);
  longer.trio(sr::neutral, spm::acknowledging, sacu::standing_by);
  CHECK(longer.breaches() == "");
  longer.cycle(sr::neutral, spm::acknowledging);
  CHECK(longer.breaks("H-17.6"));
  Stage back;
  back.wake_up();
  back.trio(sr::neutral, spm::ready, sacu::power_up);
  back.cycle(sr::neutral, spm::acknowledging);
  back.cycle(sr::neutral, spm::ready);
  CHECK(back.breaks("H-17.6"));
}

TEST_CASE("H-17.6: after a restart it is acknowledged again", "[monitor][H-17]") {
  Stage stage = attended();
  stage.trio(sr::neutral, spm::attendant, sacu::power_up);
  stage.trio(sr::neutral, spm::attendant_limping_acknowledging, sacu::neutral);
  stage.trios(5, sr::neutral, spm::attendant_limping, sacu::neutral);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-17.2: the mode told is the driver's", "[monitor][H-17]") {
  const auto breaches = [](const char* remote, const char* answer, const char* attendant) {
    Stage stage = attended();
    stage.trio(sr::neutral, spm::attendant, attendant);
    stage.trios(2, remote, answer, attendant);
    return stage.breaches();
  };
  CHECK(breaches(sr::mode_2_at_rest, spm::attendant_mode_1, sacu::mode_1_at_rest) == "");
  CHECK(breaches(sr::mode_1_at_rest, spm::attendant, sacu::neutral) == "");
  CHECK(is_caught(breaches(sr::mode_1_at_rest, spm::attendant_mode_1, sacu::neutral), "H-17.2"));
  CHECK(is_caught(breaches(sr::neutral, spm::attendant, sacu::mode_1_at_rest), "H-17.2"));
}

TEST_CASE("H-17.4: the mode that forbids driving is the driver's", "[monitor][H-17]") {
  const auto breaches = [](const char* remote, const char* attendant) {
    return breaches_of_growth(attended_at_100(), remote, spm::attendant_driving, attendant, 15ms);
  };
  CHECK(is_caught(breaches(sr::neutral, sacu::mode_1), "H-17.4"));
  CHECK(breaches(sr::mode_1, sacu::forward) == "");
}

TEST_CASE("H-17.7: mode invalid is told to the module that does not drive", "[monitor][H-17]") {
  Stage stage;
  stage.wake_up();
  stage.cycle(sr::mode_1, spm::mode_1_misplaced);
  CHECK(stage.breaks("H-17.7"));
  const auto breaches = [](const char* answer) {
    Stage attendant = attended();
    attendant.trio(sr::neutral, spm::attendant, sacu::mode_1_at_rest);
    attendant.trio(sr::neutral, answer, sacu::mode_1_at_rest);
    return attendant.breaches();
  };
  CHECK(is_caught(breaches(spm::attendant_mode_1_misplaced), "H-17.7"));
  CHECK(breaches(spm::attendant_mode_1_invalid) == "");
}

TEST_CASE("H-17.8: a mode is told as valid that one side cannot do", "[monitor][H-17]") {
  struct Case {
    const char* power_module;
    const char* remote;
    const char* turn;
    const char* answer;
    bool is_wrong;
  };
  for (const Case& one : {Case{spm::power_up_all, sr::power_up, sr::mode_1_at_rest, spm::mode_1_valid, false},
                          Case{spm::power_up_1, sr::power_up, sr::mode_1_at_rest, spm::mode_1_valid, false},
                          Case{spm::power_up_2, sr::power_up, sr::mode_1_at_rest, spm::mode_1_valid, true},
                          Case{spm::power_up_2, sr::power_up, sr::mode_2_at_rest, spm::mode_2_valid, false},
                          Case{spm::power_up_1, sr::power_up, sr::mode_2_at_rest, spm::mode_2_valid, true},
                          Case{spm::power_up_all, sr::power_up, sr::mode_3_at_rest, spm::mode_3_valid, false},
                          Case{spm::power_up_1, sr::power_up, sr::mode_3_at_rest, spm::mode_3_valid, true},
                          Case{spm::power_up_all, sr::power_up_plain, sr::mode_1_at_rest, spm::mode_1_valid, true},
                          Case{spm::power_up_all, sr::power_up_short, sr::mode_1_at_rest, spm::mode_1_valid, true}}) {
    CAPTURE(one.power_module, one.remote, one.turn);
    Stage stage;
    stage.greet(one.power_module, one.remote);
    stage.cycles(5, sr::neutral, spm::inhibited);
    stage.cycle(one.turn, one.answer);
    CHECK(stage.breaches() == (one.is_wrong ? "H-17.8" : ""));
  }
  const auto breaches = [](const char* power_up) {
    Stage stage = attended(power_up);
    stage.trio(sr::neutral, spm::attendant, sacu::mode_2_at_rest);
    stage.trio(sr::neutral, "61 92 80 C0 C0 80 82 80 8A 0F", sacu::mode_2_at_rest);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(sacu::power_up), "H-17.8"));
  CHECK(breaches(sacu::power_up_all) == "");
}

TEST_CASE("H-17.9: system is driving is told at rest, or not at work", "[monitor][H-17]") {
  Stage stage;
  stage.wake_up();
  stage.cycle(sr::neutral, spm::driving);
  CHECK(stage.breaks("H-17.9"));
  Stage hidden;
  hidden.drive_at(100);
  CHECK_FALSE(hidden.breaks("H-17.9"));
  hidden.cycle(sr::forward, spm::ready);
  CHECK(hidden.breaks("H-17.9"));
  Stage late;  // told for a turn after the brakes
  late.set_off();
  late.brakes(false);
  late.cycles(2, sr::neutral, spm::driving);
  CHECK_FALSE(late.breaks("H-17.9"));
  late.cycle(sr::neutral, spm::driving);
  CHECK(late.breaks("H-17.9"));
}

TEST_CASE("H-19.1, H-19.3, H-19.4: a duty grows though the attendant control forbids it, whoever drives",
          "[monitor][H-19]") {
  struct Case {
    const char* clause;
    const char* general;
  };
  for (const Case& one :
       {Case{"H-19.1", sacu::inhibit}, Case{"H-19.3", sacu::local_fault}, Case{"H-19.4", sacu::calibration}}) {
    CAPTURE(one.clause);
    CHECK(
        is_caught(breaches_of_growth(accompanied_at_100(), sr::forward, spm::driving, one.general, 15ms), one.clause));
    CHECK(breaches_of_growth(accompanied_at_100(), sr::forward, spm::driving, one.general, 14ms) == "");
  }
}

TEST_CASE("H-19.1: an attendant control's inhibit holds in its silence", "[monitor][H-19]") {
  Stage stage;
  stage.wake_up();
  stage.meet_attendant();
  stage.trio(sr::neutral, spm::ready, sacu::inhibit);
  stage.cycles(10, sr::neutral, spm::inhibited);
  stage.brakes(true);
  stage.run(1ms);
  CHECK(stage.breaks("H-12.1"));
  CHECK(stage.breaches() == "H-12.1");
}

TEST_CASE("H-19.1: nothing of an attendant control counts before it was acknowledged", "[monitor][H-19]") {
  Stage stage;
  stage.drive_at(100);
  stage.trios(2, sr::forward, spm::driving, sacu::inhibit);
  stage.drive(110, 110);
  stage.trios(2, sr::forward, spm::driving, sacu::inhibit);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-19.3: a joystick error counts of the module that drives", "[monitor][H-19]") {
  const auto breaches = [](const char* remote, const char* attendant, Time after) {
    return breaches_of_growth(attended_at_100(), remote, spm::attendant_driving, attendant, after);
  };
  CHECK(is_caught(breaches(sr::neutral, sacu::joystick_error, 15ms), "H-19.3"));
  CHECK(breaches(sr::neutral, sacu::joystick_error, 14ms) == "");
  CHECK(breaches(sr::joystick_error, sacu::forward, 15ms) == "");
  CHECK(is_caught(breaches(sr::local_fault, sacu::forward, 15ms), "H-19.3"));
}

TEST_CASE("H-19.4, H-19.9: a duty grows though calibration or lock is told", "[monitor][H-19]") {
  const auto breaches = [](const char* answer, Time after) {
    Stage stage;
    stage.drive_at(100);
    return breaches_of_growth(std::move(stage), sr::forward, answer, "", after);
  };
  CHECK(is_caught(breaches(spm::calibrating, 12ms), "H-19.4"));
  CHECK(is_caught(breaches(spm::calibrating_attendant, 12ms), "H-19.4"));
  CHECK(is_caught(breaches(spm::locked_only, 12ms), "H-19.9"));
  CHECK(breaches(spm::calibrating, 11ms) == "");
  CHECK(breaches(spm::locked_only, 11ms) == "");
}

TEST_CASE("H-16.1: locked for 10 s, power-down may be asked for", "[monitor][H-16]") {
  const auto breaches = [](int cycles) {
    Stage stage;
    stage.greet();
    stage.cycles(cycles, sr::neutral, "61 D2 C0 C0 80 80 80 80 CC 0F");
    stage.cycle(sr::neutral, spm::locked_down);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(480), "H-16.1"));
  CHECK(breaches(500) == "");
}

TEST_CASE("H-07.2: slowdown without a fault, or with the driver's, is no LIMP", "[monitor][H-07]") {
  const auto breaches = [](const char* answer) {
    Stage stage;
    stage.wake_up();
    stage.cycles(5, sr::neutral, answer);
    stage.cycle(sr::neutral, spm::ready);
    return stage.breaches();
  };
  CHECK(breaches(spm::dci) == "");
  CHECK(breaches(spm::user_slow) == "");
  CHECK(is_caught(breaches(spm::limping_still), "H-07.2"));
}

TEST_CASE("H-07.2: slowdown that loses its state does not make a LIMP forgotten", "[monitor][H-07]") {
  Stage stage;
  stage.wake_up();
  stage.cycles(5, sr::neutral, spm::limping_still);
  stage.cycle(sr::neutral, spm::dci);
  stage.cycle(sr::neutral, spm::ready);
  CHECK(stage.breaks("H-07.2"));
}

TEST_CASE("H-17.3: with new capabilities an established mode may be refused", "[monitor][H-17]") {
  Stage stage = attended();
  stage.trio(sr::neutral, spm::attendant, sacu::mode_1_at_rest);
  stage.trio(sr::neutral, spm::attendant_mode_1, sacu::mode_1_at_rest);
  Stage again = attended();
  again.trio(sr::neutral, spm::attendant, sacu::mode_1_at_rest);
  again.trio(sr::neutral, spm::attendant_mode_1, sacu::power_up);
  for (Stage* one : {&stage, &again}) {
    one->trio(sr::neutral, spm::attendant_mode_1_invalid, sacu::mode_1_at_rest);
  }
  CHECK(stage.breaks("H-17.3"));
  CHECK_FALSE(again.breaks("H-17.3"));
}

// A packet that another character meets may have been heard, or not.
TEST_CASE("in doubt about the switch the power module may say either", "[monitor][negotiation]") {
  const auto after_doubt = [](const char* general) {
    Stage stage = accompanied_at_100();
    stage.turn(sr::forward, spm::driving);
    stage.now -= 150us;  // it meets the power module's TF
    stage.says(Sender::sacu, general);
    stage.run(11500us);
    return stage;
  };
  Stage kept = after_doubt(sacu::forward);
  kept.trios(3, sr::forward, spm::driving, sacu::standing_by);
  CHECK(kept.breaches() == "");
  Stage taken = after_doubt(sacu::forward);
  taken.drive(0, 0, 2);
  taken.trios(3, sr::forward, spm::attendant_driving, sacu::forward);
  CHECK(taken.breaches() == "");
  taken.jump(0, 0);
  taken.brakes(false);
  taken.trios(2, sr::forward, spm::driving, sacu::forward);
  CHECK(taken.breaks("H-17.5"));
}

TEST_CASE("H-17.6: a garbled power-up packet permits an acknowledgement and demands none", "[monitor][H-17]") {
  const auto after_doubt = [] {
    Stage stage;
    stage.wake_up();
    stage.turn(sr::neutral, spm::ready);
    stage.now -= 150us;
    stage.says(Sender::sacu, sacu::power_up);
    stage.run(11500us);
    return stage;
  };
  for (const char* answer : {spm::ready, spm::acknowledging}) {
    Stage stage = after_doubt();
    stage.cycle(sr::neutral, answer);
    CHECK(stage.breaches() == "");
  }
}

TEST_CASE("H-07.1, H-19.3: stick and pot of an attendant control that stands by do not count",
          "[monitor][H-07][H-19]") {
  const auto breaches = [](const char* general) {
    Stage stage;
    stage.wake_up();
    stage.meet_attendant(sacu::power_up_all);
    stage.trios(2, sr::neutral, spm::ready, general);
    stage.trio(sr::forward, spm::ready, general);
    stage.brakes(true);
    stage.trios(6, sr::forward, spm::driving, general);
    return stage.breaches();
  };
  CHECK(breaches("58 C0 C0 FF C0 C0 80 A8 0F") == "");  // joystick error
  CHECK(breaches("58 C0 C0 FF C0 A0 80 C8 0F") == "");  // pot error
  CHECK(breaches(sacu::standing_by_forward) == "");
}

TEST_CASE("H-02.4: a hand-over ends with the stand, and then five generals are enough", "[monitor][H-02]") {
  const auto breaches = [](int neutrals) {
    Stage stage = accompanied_at_100();
    stage.later(8ms, [&] { stage.drive(0, 0); });
    stage.trio(sr::forward, spm::driving, sacu::neutral);
    stage.trios(6, sr::forward, "61 92 C0 C0 E0 80 80 80 AC 0F", sacu::neutral);
    stage.brakes(false);
    stage.run(20ms);
    stage.trios(neutrals, sr::forward, spm::attendant_inhibited, sacu::neutral);
    stage.trio(sr::forward, spm::attendant_awaiting, sacu::forward);
    stage.brakes(true);
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(is_caught(breaches(4), "H-12.1"));
  CHECK(breaches(5) == "");
}

TEST_CASE("H-18.2: the remote moves no actuator while the attendant control drives", "[monitor][H-18]") {
  const auto breaches = [](const char* remote, const char* attendant) {
    Stage stage = attended();
    stage.trio(sr::neutral, spm::attendant, sacu::mode_1_at_rest);
    stage.trios(5, sr::neutral, spm::attendant_mode_1, sacu::mode_1_at_rest);
    stage.trio(remote, spm::attendant_mode_1, attendant);
    stage.pins.actuator1_extend = true;
    stage.run(1ms);
    return stage.breaches();
  };
  CHECK(breaches(sr::neutral, sacu::mode_1) == "");
  CHECK(is_caught(breaches(sr::mode_1, sacu::mode_1_at_rest), "H-18.2"));
}
