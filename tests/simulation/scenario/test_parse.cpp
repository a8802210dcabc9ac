#include <catch2/catch.hpp>

#include <string>

#include "simulation/board/host_board.hpp"
#include "simulation/eeprom/layout.hpp"
#include "simulation/scenario/parse.hpp"

namespace {

using namespace simulation;
using namespace simulation::scenario;

std::string complaints_about(const std::string& text) {
  try {
    parse_scenario(text, "file.yaml");
  } catch (const BadScenario& bad) {
    return bad.what();
  }
  return "";
}

const std::string head = "name: a test\nsteps:\n";

}  // namespace

TEST_CASE("a time without a unit is named with its place and its remedy") {
  CHECK(complaints_about(head + "  - wait: 60\n") == "file.yaml:3:11: 60 has no unit: write 60ms");
}

TEST_CASE("an unknown step is named with the nearest known one") {
  CHECK(complaints_about(head + "  - expcet: {motors: stopped}\n") ==
        "file.yaml:3:5: unknown step 'expcet' (did you mean 'expect'?)");
  CHECK(complaints_about(head + "  - wakeup\n") == "file.yaml:3:5: unknown step 'wakeup' (did you mean 'wake'?)");
}

TEST_CASE("an unknown condition, control or key is named with the nearest known one") {
  CHECK(complaints_about(head + "  - expect: {motor: stopped}\n") ==
        "file.yaml:3:14: unknown condition 'motor' (did you mean 'motors'?)");
  CHECK(complaints_about(head + "  - expect: {chair: {sped: \"> 1m/s\"}}\n") ==
        "file.yaml:3:22: unknown condition 'chair sped' (did you mean 'speed'?)");
  CHECK(complaints_about(head + "  - sr: {sped: 60%}\n") == "file.yaml:3:10: sr has no 'sped' (did you mean 'speed'?)");
  CHECK(complaints_about("nmae: x\n" + head) ==
        "file.yaml:1:1: a scenario has no 'nmae' (did you mean 'name'?)\n"
        "file.yaml:4:1: 'steps' must be a list: each step on a line of its own after '- '");
}

TEST_CASE("a value of the wrong type is named") {
  CHECK(complaints_about(head + "  - wait: {a: 1s}\n") ==
        "file.yaml:3:11: expected a time such as 60ms, 1.5s or 250us, found a map");
  CHECK(complaints_about(head + "  - expect: stopped\n") ==
        "file.yaml:3:13: a condition must be a map of 'word: value', found 'stopped'");
  CHECK(complaints_about(head + "  - sr: {horn: loud}\n") ==
        "file.yaml:3:16: expected on or off (or yes, no), found 'loud'");
  CHECK(complaints_about(head + "  - expect: {motors: resting}\n") ==
        "file.yaml:3:22: 'resting' is not one of: driving, stopped, not speeding up");
  CHECK(complaints_about(head + "  - expect: {speedo: \"> 5ms\"}\n") ==
        "file.yaml:3:22: '5ms' must be a number without a unit");
  CHECK(complaints_about(head + "  - send: {bytes: \"60 C\"}\n") ==
        "file.yaml:3:19: 'C' is not a byte: write two hexadecimal digits, as in \"60 C0 0F\"");
}

TEST_CASE("a companion that is missing or does not belong is named") {
  CHECK(complaints_about(head + "  - hold: {motors: stopped}\n") == "file.yaml:3:5: step 'hold' needs 'for'");
  CHECK(complaints_about(head + "  - wait: 1s\n    within: 2s\n") ==
        "file.yaml:4:5: step 'wait' has no 'within' (known: wait)");
}

TEST_CASE("all that is wrong comes out at once, in the order of lines") {
  CHECK(complaints_about(head + "  - wait: 60\n  - slop: 1deg\n  - wait: 5\n") ==
        "file.yaml:3:11: 60 has no unit: write 60ms\n"
        "file.yaml:4:5: unknown step 'slop' (did you mean 'slope'?)\n"
        "file.yaml:5:11: 5 has no unit: write 5ms");
}

TEST_CASE("clause ids, boards and the given situation are checked") {
  CHECK(complaints_about("spec: [SB-2.14, 2.15]\n" + head + "  - wake\n") ==
        "file.yaml:1:7: '2.15' is neither a clause's id such as SB-2.15 nor a hazard's such as H-04");
  CHECK(complaints_about("needs: pic\n" + head + "  - wake\n") == "file.yaml:1:8: 'pic' is not a board: avr, host");
  CHECK(complaints_about("given: asleep\n" + head + "  - wake\n") ==
        "file.yaml:1:8: 'asleep' is not a start: off, awake, awake with attendant, driving at 60%");
  CHECK(complaints_about("given: driving at 60\n" + head + "  - wake\n") == "file.yaml:1:8: 60 has no unit: write 60%");
}

TEST_CASE("the monitor's clauses are left out one by one, with a reason") {
  CHECK(complaints_about("monitor: {except: [H-04.1]}\n" + head + "  - wake\n") ==
        "file.yaml:1:10: 'monitor' needs 'because'");
  CHECK(complaints_about("monitor: {except: [H-04], because: it is so}\n" + head + "  - wake\n") ==
        "file.yaml:1:19: 'H-04' is no clause of the monitor, such as H-04.1: see list-clauses");
  CHECK(complaints_about("monitor: {because: it is so}\n" + head + "  - wake\n") ==
        "file.yaml:1:10: 'monitor' needs 'except'");
  CHECK(complaints_about("monitor: {except: [H-04.1], because: \"\"}\n" + head + "  - wake\n") ==
        "file.yaml:1:38: say why the clauses may be broken");
  const auto scenario =
      parse_scenario("monitor: {except: [H-04.1, H-30.1], because: it is so}\n" + head + "  - wake\n", "file.yaml");
  CHECK(scenario.exceptions.clauses == std::vector<std::string>{"H-04.1", "H-30.1"});
  CHECK(scenario.exceptions.because == "it is so");
}

TEST_CASE("broken YAML is named with its place") {
  CHECK_THAT(complaints_about(head + "  - expect: {speedo: > 5}\n"), Catch::StartsWith("file.yaml:3:"));
  CHECK_THAT(complaints_about("just words"), Catch::StartsWith("file.yaml: a scenario is a map"));
}

TEST_CASE("a good file becomes plain steps") {
  const auto scenario = parse_scenario(
      "name: a test\nspec: [SB-2.15]\ntags: [x]\nseed: 7\nneeds: avr\nsteps:\n"
      "  - wait: 60ms\n"
      "  - expect: {motors: stopped, chair: {speed: \"< 1m/s\"}}\n    within: 2s\n"
      "  - sr: {speed: -50%, pot raw: 128}\n"
      "  - send: {bytes: \"0F\", every: 20ms, for: 1s}\n"
      "  - fault: {corrupt checksum: SR general, count: 3}\n",
      "file.yaml");
  CHECK(scenario.spec == std::vector<std::string>{"SB-2.15"});
  CHECK(scenario.seed == 7U);
  CHECK(scenario.needs == std::vector<std::string>{"avr"});
  REQUIRE(scenario.steps.size() == 5);
  CHECK(std::get<Wait>(scenario.steps[0].action).span == 60ms);

  const auto& expect = std::get<Expect>(scenario.steps[1].action);
  CHECK(expect.within == 2s);
  REQUIRE(expect.conditions.size() == 2);
  CHECK(expect.conditions[1].text == "chair speed: < 1m/s");
  CHECK(expect.conditions[1].mark == Mark{8, 39});

  RemoteControls controls;
  for (const auto& change : std::get<SetControls>(scenario.steps[2].action).changes) {
    change(controls);
  }
  CHECK(controls.speed == 256);
  CHECK(controls.pot == 128);

  CHECK(std::get<Send>(scenario.steps[3].action).times == 50);
  CHECK(std::get<Disturb>(scenario.steps[4].action).count == 3);
}

TEST_CASE("full stick is full scale in both directions", "[SB-00.8]") {
  const auto scenario = parse_scenario(head + "  - sr: {speed: 100%, direction: -100%}\n", "file.yaml");
  RemoteControls controls;
  for (const auto& change : std::get<SetControls>(scenario.steps[0].action).changes) {
    change(controls);
  }
  CHECK(controls.speed == 1023);
  CHECK(controls.direction == 0);
}

TEST_CASE("what an attendant control does becomes controls and habits") {
  const auto scenario = parse_scenario(head +
                                           "  - sacu: attached\n"
                                           "  - sacu: {speed: 40%, attendant: on, drive inhibit: on, insists: on,"
                                           " follows: SR, pause: 600us, capabilities: 7}\n"
                                           "  - sacu: detached\n",
                                       "file.yaml");
  CHECK(std::get<SetSacu>(scenario.steps[0].action).is_attached == true);
  CHECK(std::get<SetSacu>(scenario.steps[2].action).is_attached == false);
  const auto& set = std::get<SetSacu>(scenario.steps[1].action);
  CHECK_FALSE(set.is_attached);
  Sacu sacu;
  for (const auto& change : set.changes) {
    change(sacu.controls);
  }
  for (const auto& habit : set.habits) {
    habit.change(sacu);
  }
  CHECK(sacu.controls.speed == 716);
  CHECK(sacu.controls.is_attendant);
  CHECK(sacu.controls.drive_inhibit);
  CHECK(sacu.insists);
  CHECK(sacu.timing.is_rash);
  CHECK(sacu.timing.pause == 600us);
  CHECK(sacu.identity.capabilities == 7);
}

TEST_CASE("a remote's clock, stop bits and gaps can be set") {
  const auto scenario = parse_scenario(
      head + "  - remote: {bit rate: +2%, stop bits: 1, gap: 1300us, calibration packets: on}\n", "file.yaml");
  Remote remote;
  for (const auto& habit : std::get<SetRemote>(scenario.steps[0].action).habits) {
    habit.change(remote);
  }
  CHECK(remote.timing.bit_us == Approx(25.531));
  CHECK(remote.timing.stop_bits == 1);
  CHECK(remote.timing.gap == 1300us);
  CHECK(remote.sends_calibration);
}

TEST_CASE("the programmer's characters have eight bits") {
  const auto scenario =
      parse_scenario(head + "  - programmer: {types: \"a\\r\\x83\"}\n  - programmer: clears\n", "file.yaml");
  CHECK(std::get<UseProgrammer>(scenario.steps[0].action).types == "a\r\x83");
  CHECK(std::get<UseProgrammer>(scenario.steps[1].action).clears);
  CHECK(complaints_about(head + "  - programmer: {types: \"\\u20ac\"}\n") ==
        "file.yaml:3:25: a character is beyond 0xFF: the programmer's have eight bits, as in \"a\\x83\"");
  CHECK(complaints_about(head + "  - programmer: {types: \"\"}\n") ==
        "file.yaml:3:25: expected characters, as in \"hello\\r\"");
}

TEST_CASE("what the programmer shall see is shown with escapes") {
  const auto scenario =
      parse_scenario(head + "  - expect: {programmer sees: \"OK\\r\", programmer characters: \">= 3\"}\n", "file.yaml");
  const auto& conditions = std::get<Expect>(scenario.steps[0].action).conditions;
  REQUIRE(conditions.size() == 2);
  CHECK(conditions[0].text == "programmer sees: \"OK\\r\"");
}

TEST_CASE("mistakes about remote, attendant control and programmer are named with a remedy") {
  CHECK(complaints_about(head + "  - sacu: {atendant: on}\n") ==
        "file.yaml:3:12: sacu has no 'atendant' (did you mean 'attendant'?)");
  CHECK(complaints_about(head + "  - sacu: plugged\n") ==
        "file.yaml:3:11: 'plugged' is not one of: attached, detached");
  CHECK(complaints_about(head + "  - sacu: {pause: 100}\n") == "file.yaml:3:19: 100 has no unit: write 100ms");
  CHECK(complaints_about(head + "  - remote: {bitrate: +2%}\n") ==
        "file.yaml:3:14: remote has no 'bitrate' (did you mean 'bit rate'?)");
  CHECK(complaints_about(head + "  - remote: {bit rate: +20%}\n") ==
        "file.yaml:3:24: +20% is out of range: -10% to +10%");
  CHECK(complaints_about(head + "  - remote: {stop bits: 3}\n") ==
        "file.yaml:3:25: 3 must be a whole number from 1 to 2");
  CHECK(complaints_about(head + "  - programmer: {type: \"x\"}\n") ==
        "file.yaml:3:17: programmer needs 'types'\n"
        "file.yaml:3:18: programmer has no 'type' (did you mean 'types'?)");
  CHECK(complaints_about(head + "  - programer: clears\n") ==
        "file.yaml:3:5: unknown step 'programer' (did you mean 'programmer'?)");
}

TEST_CASE("what the event log remembers is asked for in its own words") {
  const auto scenario = parse_scenario(
      head + "  - expect: {last event: \"started, after a watchdog reset\", events include: the remote fell silent}\n",
      "file.yaml");
  const auto& conditions = std::get<Expect>(scenario.steps[0].action).conditions;
  REQUIRE(conditions.size() == 2);
  CHECK(conditions[0].text == "last event: started, after a watchdog reset");
  World world(make_host_board());
  const report::Facts facts(world);
  const auto holds = [&](std::size_t i) { return conditions[i].holds(facts, facts.anchor()); };
  CHECK_FALSE(holds(0));
  CHECK(conditions[0].seen(facts, facts.anchor()) == "nothing yet");
  std::vector<std::uint8_t> eeprom(4096, 0xFF);
  eeprom::write_record(eeprom, {0, 17, 0, 3, 1});
  eeprom::write_record(eeprom, {1, 1, 1, 0, 2});
  world.board().set_eeprom(eeprom);
  CHECK(holds(0));
  CHECK(holds(1));
  eeprom::write_record(eeprom, {2, 1, 2, 0, 3});
  world.board().set_eeprom(eeprom);
  CHECK_FALSE(holds(0));
  CHECK(conditions[0].seen(facts, facts.anchor()) == "started, started, after a brown-out");
  CHECK_THAT(complaints_about(head + "  - expect: {last event: startet}\n"),
             Catch::Contains("'startet' is not one of: started, "));
}

TEST_CASE("a part of the chair is broken and mended on one side") {
  const auto scenario = parse_scenario(head +
                                           "  - fault: {stuck bridge: right}\n  - restore: {stuck bridge: right}\n"
                                           "  - fault: {open brake coil: left}\n  - restore: cable\n",
                                       "file.yaml");
  const auto& broken = std::get<Break>(scenario.steps[0].action);
  CHECK(broken.damage == Damage::stuck_bridge);
  CHECK(broken.side == Side::right);
  CHECK(broken.is_broken);
  const auto& mended = std::get<Break>(scenario.steps[1].action);
  CHECK(mended.damage == Damage::stuck_bridge);
  CHECK(mended.side == Side::right);
  CHECK_FALSE(mended.is_broken);
  CHECK(std::get<Break>(scenario.steps[2].action).damage == Damage::open_coil);
  CHECK(std::get<Break>(scenario.steps[2].action).side == Side::left);
  CHECK(std::holds_alternative<MendCable>(scenario.steps[3].action));
  CHECK(complaints_about(head + "  - fault: {open motor: both}\n") ==
        "file.yaml:3:25: 'both' is not one of: left, right");
  CHECK(complaints_about(head + "  - restore: {}\n") ==
        "file.yaml:3:14: restore what? write 'restore: cable' or "
        "'restore: {stuck bridge: right}'");
  CHECK(complaints_about(head + "  - restore: bridge\n") == "file.yaml:3:14: 'bridge' is not one of: cable");
}

TEST_CASE("Bits of the chip's memory are named by place, number and level", "[H-27]") {
  const std::string head = "name: x\nsteps:\n";
  const Scenario scenario = parse_scenario(head +
                                               "  - fault: {flash bit: 38000, bit: 3}\n"
                                               "  - fault: {stuck RAM bit: 9000, bit: 7, level: high}\n",
                                           "file.yaml");
  const Upset flash = std::get<SpoilMemory>(scenario.steps[0].action).upset;
  CHECK(flash.memory == Upset::Memory::flash);
  CHECK(flash.address == 38000);
  CHECK(flash.bit == 3);
  const Upset ram = std::get<SpoilMemory>(scenario.steps[1].action).upset;
  CHECK(ram.memory == Upset::Memory::ram);
  CHECK(ram.address == 9000);
  CHECK(ram.bit == 7);
  CHECK(ram.is_stuck_high);
  CHECK_FALSE(complaints_about(head + "  - fault: {flash bit: 38144, bit: 3}\n").empty());
  CHECK_FALSE(complaints_about(head + "  - fault: {stuck RAM bit: 255, bit: 3, level: low}\n").empty());
  CHECK_FALSE(complaints_about(head + "  - fault: {stuck RAM bit: 9000, bit: 8, level: low}\n").empty());
  CHECK_FALSE(complaints_about(head + "  - fault: {stuck RAM bit: 9000, bit: 3}\n").empty());
}

TEST_CASE("Lamps and actuators are broken and mended by name", "[negotiation]") {
  const auto scenario =
      parse_scenario(head +
                         "  - fault: {shorted lamp: headlight}\n  - restore: {open lamp: right indicator}\n"
                         "  - fault: {no end switch: 2}\n  - restore: {blocked actuator: 1}\n",
                     "file.yaml");
  const auto& lamp = std::get<BreakLamp>(scenario.steps[0].action);
  CHECK(lamp.damage == LampDamage::shorted);
  CHECK(lamp.place == LampPlace::headlight);
  CHECK(lamp.is_broken);
  const auto& mended_lamp = std::get<BreakLamp>(scenario.steps[1].action);
  CHECK(mended_lamp.damage == LampDamage::open);
  CHECK(mended_lamp.place == LampPlace::right_indicator);
  CHECK_FALSE(mended_lamp.is_broken);
  const auto& actuator = std::get<BreakActuator>(scenario.steps[2].action);
  CHECK(actuator.damage == ActuatorDamage::no_end_switch);
  CHECK(actuator.number == 2);
  CHECK(actuator.is_broken);
  const auto& mended = std::get<BreakActuator>(scenario.steps[3].action);
  CHECK(mended.damage == ActuatorDamage::blocked);
  CHECK(mended.number == 1);
  CHECK_FALSE(mended.is_broken);
  CHECK(complaints_about(head + "  - fault: {open lamp: left}\n") ==
        "file.yaml:3:24: 'left' is not one of: left indicator, right indicator, headlight");
  CHECK(complaints_about(head + "  - fault: {blocked actuator: 3}\n") ==
        "file.yaml:3:31: 3 must be a whole number from 1 to 2");
  CHECK(complaints_about(head + "  - fault: {shortet lamp: headlight}\n") ==
        "file.yaml:3:13: unknown fault 'shortet lamp' (did you mean 'shorted lamp'?)");
  CHECK(complaints_about(head + "  - fault: {open lamp: headlight, count: 2}\n") ==
        "file.yaml:3:35: fault 'open lamp' has no 'count' (known: open lamp)");
}

TEST_CASE("The head says what is fitted, and what the EEPROM holds at the first start", "[negotiation]") {
  const auto plain = parse_scenario(head + "  - wake\n", "file.yaml");
  CHECK(plain.module.is_there);
  CHECK(plain.module.has_lighting);
  CHECK(plain.module.eeprom.empty());
  const auto scenario =
      parse_scenario("fitted: {lighting: no, power module: no}\nsettings: {lock_mode_enable: 0, deadband: 40}\n" +
                         head + "  - dci: on\n  - dci: off\n",
                     "file.yaml");
  CHECK_FALSE(scenario.module.is_there);
  CHECK_FALSE(scenario.module.has_lighting);
  REQUIRE(scenario.module.eeprom.size() == 4096);
  CHECK(int(scenario.module.eeprom[4]) == 40);    // deadband is the first
  CHECK(int(scenario.module.eeprom[132]) == 40);  // in both copies
  CHECK(std::get<Dci>(scenario.steps[0].action).is_on);
  CHECK_FALSE(std::get<Dci>(scenario.steps[1].action).is_on);
}

TEST_CASE("Mistakes at the head are named with their place and a remedy", "[negotiation]") {
  const std::string rest = "\n" + head + "  - wake\n";
  CHECK(complaints_about("settings: {sleep_timeot: 1}" + rest) ==
        "file.yaml:1:12: no setting 'sleep_timeot' (did you mean 'sleep_timeout'?)");
  CHECK(complaints_about("settings: {colour: 1}" + rest) ==
        "file.yaml:1:12: no setting 'colour' (pilotfish list-steps tells all)");
  CHECK(complaints_about("settings: {sleep_timeout: 300}" + rest) ==
        "file.yaml:1:27: 300 must be a whole number from 0 to 240");
  CHECK(complaints_about("settings: {deadband: 9, stick_travel: 512}" + rest) ==
        "file.yaml:1:22: 9 must be a whole number from 10 to 100\n"
        "file.yaml:1:39: 512 must be a whole number from 200 to 511");
  CHECK(complaints_about("fitted: {lights: no}" + rest) ==
        "file.yaml:1:10: fitted has no 'lights' (known: lighting, power module)");
  CHECK(complaints_about("fitted: {lighting: 3}" + rest) ==
        "file.yaml:1:20: expected on or off (or yes, no), found '3'");
  CHECK(complaints_about(head + "  - dci: slow\n") == "file.yaml:3:10: expected on or off (or yes, no), found 'slow'");
}

TEST_CASE("Awake with attendant: plugged in before the press, and it has to send generals", "[negotiation]") {
  const auto scenario = parse_scenario("given: awake with attendant\n" + head + "  - wait: 1s\n", "file.yaml");
  REQUIRE(scenario.steps.size() == 6);
  CHECK(std::get<SetSacu>(scenario.steps[0].action).is_attached == true);
  CHECK(std::holds_alternative<PressPower>(scenario.steps[1].action));
  const auto& asked = std::get<Expect>(scenario.steps[4].action).conditions;
  REQUIRE(asked.size() == 1);
  CHECK(asked[0].text == "SACU sends: general");
}

TEST_CASE("Actuators and lamps are asked for in words, places and amperes", "[negotiation]") {
  const auto scenario =
      parse_scenario(head +
                         "  - expect: {actuator 1: extending, actuator 2: \"off\", actuator 1 position: \"> 60%\"}\n"
                         "  - expect: {left indicator pin: on, right indicator pin: off, headlight pin: on, headlight "
                         "current: \"> 2A\"}\n"
                         "  - expect: {actuator 2: {position: \"50%\"}}\n",
                     "file.yaml");
  World world(make_host_board());
  Facts facts(world);
  const auto holds = [&](std::size_t step, const Pins& pins, const ChairState& chair) {
    Sample sample;
    sample.pins = pins;
    sample.chair = chair;
    facts.on_sample(sample);
    std::string seen;
    for (const Condition& condition : std::get<Expect>(scenario.steps[step].action).conditions) {
      seen += condition.holds(facts, {}) ? 'y' : 'n';
    }
    return seen;
  };
  Pins pins;
  ChairState chair;
  CHECK(holds(0, pins, chair) == "nyn");
  pins.actuator1_extend = true;
  chair.actuator1_position = 0.61;
  CHECK(holds(0, pins, chair) == "yyy");
  pins.actuator1_retract = true;
  pins.actuator2_retract = true;
  CHECK(holds(0, pins, chair) == "nny");
  CHECK(holds(1, pins, chair) == "nynn");
  pins.left_indicator = pins.headlight = true;
  chair.headlight_current = 2.5;
  CHECK(holds(1, pins, chair) == "yyyy");
  pins.right_indicator = true;
  CHECK(holds(1, pins, chair) == "ynyy");
  CHECK(holds(2, pins, chair) == "y");
  chair.actuator2_position = 0.4;
  CHECK(holds(2, pins, chair) == "n");
}

TEST_CASE("What remote and attendant control send is asked for apart", "[SB-07.1][negotiation]") {
  const auto scenario =
      parse_scenario(head +
                         "  - send: {as: tester, bytes: \"27 80 C5 80 93 0F\"}\n"
                         "  - expect: {SR sends: \"27 A0 C5 A5 CE\", SACU sends: \"27 A0 C5 A5 CE\"}\n"
                         "  - expect: {SR silent: yes, SACU silent: yes}\n",
                     "file.yaml");
  CHECK(std::get<Send>(scenario.steps[0].action).as == Sender::tester);
  World world(make_host_board());
  Facts facts(world);
  const auto holds = [&](std::size_t step) {
    std::string seen;
    for (const Condition& condition : std::get<Expect>(scenario.steps[step].action).conditions) {
      seen += condition.holds(facts, {}) ? 'y' : 'n';
    }
    return seen;
  };
  Time start = 10ms;
  const auto say = [&](Sender sender) {
    for (const int value : {0x27, 0xA0, 0xC5, 0xA5, 0xCE, 0x0F}) {
      const auto byte = static_cast<std::uint8_t>(value);
      facts.on_byte({start, start + 286us, sender, byte, byte});
      start += 286us;
    }
  };
  CHECK(holds(1) == "nn");
  CHECK(holds(2) == "yy");
  say(Sender::tester);
  CHECK(holds(1) == "nn");
  CHECK(holds(2) == "yy");
  say(Sender::sacu);
  CHECK(holds(1) == "ny");
  CHECK(holds(2) == "yn");
  say(Sender::sr);
  CHECK(holds(1) == "yy");
  CHECK(holds(2) == "nn");
}
