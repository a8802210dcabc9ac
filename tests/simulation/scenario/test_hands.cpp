#include "simulation/scenario/hands.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "simulation/board/host_board.hpp"

namespace {

using namespace simulation;
using namespace simulation::scenario;
using Bytes = std::vector<std::uint8_t>;

struct Bench : Observer {
  Bench() : world(make_host_board()), hands(world) { world.observe(*this); }
  void on_byte(const BusByte& byte) override { bytes.push_back(byte); }

  void run(Time span) {
    const Time end = world.now() + span;
    while (world.now() < end) {
      world.run_until(std::clamp(hands.next_due().value_or(end), world.now(), end));
      hands.send_if_due();
    }
  }
  Bytes heard() const {
    Bytes values;
    for (const BusByte& byte : bytes) {
      values.push_back(byte.heard);
    }
    return values;
  }

  World world;
  Hands hands;
  std::vector<BusByte> bytes;
};

SetControls set(std::function<void(RemoteControls&)> change) {
  return SetControls{{std::move(change)}};
}

}  // namespace

TEST_CASE("The power button wakes, and is down while it is pressed") {
  Bench bench;
  CHECK(bench.hands.press_power(true) == "the driver presses the power button");
  CHECK(bench.world.remote().is_on());
  CHECK(bench.world.remote().controls.power_button);
  CHECK(bench.world.spm_powered());
  CHECK(bench.hands.press_power(false).empty());
  CHECK_FALSE(bench.world.remote().controls.power_button);
}

TEST_CASE("What a hand does to the remote is told by what changed") {
  Bench bench;
  Hands& hands = bench.hands;
  CHECK(hands.apply(set([](RemoteControls& c) { c.speed = 800; })) == "the driver moves the stick");
  CHECK(hands.apply(set([](RemoteControls& c) { c.speed = 800; })).empty());
  CHECK(hands.apply(set([](RemoteControls& c) { c.speed = 512; })) == "the driver lets go of the stick");
  CHECK(hands.apply(set([](RemoteControls& c) { c.joystick_error = true; })) == "the remote reports a joystick error");
  CHECK(hands.apply(set([](RemoteControls& c) { c.joystick_error = false; })) == "the joystick error is over");
  CHECK(hands.apply(set([](RemoteControls& c) {
    c.direction = 300;
    c.pot = 10;
    c.mode = 4;
  })) == "the driver moves the stick, the driver turns the speed pot, the remote asks for mode 4");
  CHECK(bench.world.remote().controls.direction == 300);
}

TEST_CASE("The remote itself can be changed") {
  Bench bench;
  CHECK(bench.hands.apply(SetRemote{false, std::nullopt, {}}) == "the remote falls silent");
  CHECK(bench.world.remote().is_silent);
  CHECK(bench.hands.apply(SetRemote{false, std::nullopt, {}}).empty());
  CHECK(bench.hands.apply(SetRemote{true, 66ms, {}}) == "the remote talks again, the remote sends every 66ms");
  CHECK(bench.world.remote().timing.period == 66ms);
  CHECK(bench.hands.apply(SetRemote{std::nullopt, std::nullopt, {[](RemoteIdentity& i) { i.general_length = 6; }}}) ==
        "the remote is of another kind");
  CHECK(bench.world.remote().identity.general_length == 6);
}

TEST_CASE("What hands do to the attendant control is told by what changed") {
  Bench bench;
  Hands& hands = bench.hands;
  CHECK(hands.apply(SetSacu{true}) == "an attendant control is plugged in");
  CHECK(bench.world.sacu().is_attached());
  CHECK(hands.apply(SetSacu{true}).empty());
  CHECK(hands.apply(SetSacu{std::nullopt,
                            {[](SacuControls& c) { c.speed = 700; }, [](SacuControls& c) { c.is_attendant = true; }},
                            {{[](Sacu& s) { s.insists = true; }, "the attendant control insists"}}}) ==
        "the attendant moves the stick, the attendant takes over, the attendant control insists");
  CHECK(bench.world.sacu().controls.speed == 700);
  CHECK(bench.world.sacu().insists);
  CHECK(hands.apply(SetSacu{false}) == "the attendant control is unplugged");
  CHECK_FALSE(bench.world.sacu().is_attached());
}

TEST_CASE("The programmer types into the remote, and can clear its screen") {
  Bench bench;
  CHECK(bench.hands.apply(UseProgrammer{"hi\r"}) == "the programmer sends \"hi\\r\"");
  Programmer& programmer = bench.world.remote().programmer;
  CHECK(programmer.take(8) == "hi\r");
  programmer.show('x');
  CHECK(bench.hands.apply(UseProgrammer{"", true}).empty());
  CHECK(programmer.screen().empty());
}

TEST_CASE("Deeds on wire, ground and supply are done and told") {
  Bench bench;
  Hands& hands = bench.hands;
  CHECK(hands.apply(CutCable{}) == "the cable is cut");
  CHECK(bench.world.wire().is_cut());
  CHECK(hands.apply(MendCable{}) == "the cable is mended");
  CHECK_FALSE(bench.world.wire().is_cut());
  CHECK(hands.apply(WakePulse{20ms}) == "SBH is pulled up for 20ms");
  CHECK(bench.world.wire().is_wake_asserted());
  CHECK(hands.apply(Babble{2s}) == "somebody babbles on the bus for 2s");
  CHECK(hands.apply(Babble{2s, 0.5}) == "somebody babbles on the bus for 2s, 50% of the time");
  CHECK(hands.apply(Jam{300ms}) == "a transmitter hangs for 300ms");
  CHECK(hands.apply(Slope{6}) == "the ground is at 6deg");
  CHECK(hands.apply(scenario::Battery{22}) == "the batteries have 22V");
  bench.run(1ms);
  CHECK(bench.world.latest().chair.battery_volts == Approx(22).margin(0.1));
  CHECK(hands.apply(Break{Damage::open_coil, Side::left}) == "the left park brake's wire is off");
  CHECK(hands.apply(Break{Damage::shorted_coil, Side::right}) == "the right park brake's coil is shorted");
  CHECK(hands.apply(Break{Damage::stuck_bridge, Side::right}) == "the right bridge is stuck: full voltage, forward");
  CHECK(hands.apply(Break{Damage::open_motor, Side::left}) == "the left motor's wire is off");
  CHECK(hands.apply(Break{Damage::open_motor, Side::left, false}) == "the left motor's wire is mended");
  CHECK(hands.apply(Reset::watchdog) == "the watchdog bites");
  CHECK(bench.world.board().statistics().resets == 1);
}

TEST_CASE("Lamps, actuators and the seat's input are changed and told", "[negotiation]") {
  Bench bench;
  Hands& hands = bench.hands;
  Chair& chair = bench.world.chair();
  CHECK(hands.apply(BreakLamp{LampDamage::open, LampPlace::left_indicator}) == "the left indicator's wire is off");
  CHECK(chair.lamp(LampPlace::left_indicator).current(true) == 0);
  CHECK(hands.apply(BreakLamp{LampDamage::open, LampPlace::left_indicator, false}) == "the left indicator is mended");
  CHECK(chair.lamp(LampPlace::left_indicator).current(true) == 1.75);
  CHECK(hands.apply(BreakLamp{LampDamage::shorted, LampPlace::right_indicator}) == "the right indicator is shorted");
  CHECK(hands.apply(BreakLamp{LampDamage::shorted, LampPlace::headlight}) == "the headlight is shorted");
  CHECK(chair.lamp(LampPlace::headlight).current(true) == 8);
  CHECK(hands.apply(BreakActuator{ActuatorDamage::open, 1}) == "actuator 1's wire is off");
  CHECK(hands.apply(BreakActuator{ActuatorDamage::shorted, 2}) == "actuator 2 is shorted");
  CHECK(chair.actuator(1).current(true, false) == 0);
  CHECK(chair.actuator(2).current(true, false) == 20);
  CHECK(hands.apply(BreakActuator{ActuatorDamage::shorted, 2, false}) == "actuator 2 is mended");
  CHECK(hands.apply(BreakActuator{ActuatorDamage::blocked, 2}) == "actuator 2 is blocked");
  CHECK(chair.actuator(2).current(true, false) == 9);
  CHECK(hands.apply(BreakActuator{ActuatorDamage::no_end_switch, 1}) == "actuator 1 has lost its end switches");
  CHECK(hands.apply(Dci{true}) == "the seat asks for slow");
  CHECK(hands.apply(Dci{false}) == "the seat asks for slow no more");
}

TEST_CASE("A disturbance names its victims") {
  Bench bench;
  Disturb disturb;
  disturb.count = 3;
  CHECK(bench.hands.apply(disturb) == "noise changes the checksum of the next 3 SR generals");
  disturb = {Disturb::Way::flip_bit, Sender::spm, 0x01, 6, 3, 1};
  CHECK(bench.hands.apply(disturb) == "noise flips bit 3 of byte 6 of the next SPM general");
  disturb = {Disturb::Way::drop, Sender::sr, 0x0F, 0, 0, 5};
  CHECK(bench.hands.apply(disturb) == "noise swallows the next 5 SR TFs");
  bench.world.wire().send(Sender::sr, {0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F}, bench.world.now());
  bench.run(10ms);
  REQUIRE(bench.bytes.size() == 10);
  CHECK(bench.bytes[8].heard == 0xDD);
  CHECK(bench.bytes[9].lost);
}

TEST_CASE("Bytes are sent on their beat until the sending stops") {
  Bench bench;
  bench.run(3ms);
  bench.hands.begin_sending({Sender::sacu, {0x11, 0x22}, 10ms, std::nullopt});
  CHECK(bench.hands.next_due() == 3ms);
  bench.run(25ms);
  CHECK(bench.heard() == Bytes{0x11, 0x22, 0x11, 0x22, 0x11, 0x22});
  CHECK(bench.bytes[0].sender == Sender::sacu);
  CHECK(bench.bytes[2].start == 13ms);
  bench.hands.stop_sending();
  CHECK_FALSE(bench.hands.next_due().has_value());
  bench.run(50ms);
  CHECK(bench.bytes.size() == 6);
}

TEST_CASE("A new sending takes over at the next beat, and ends after its times") {
  Bench bench;
  bench.hands.begin_sending({Sender::sr, {0x11}, 10ms, std::nullopt});
  bench.run(15ms);
  bench.hands.begin_sending({Sender::sr, {0x22}, 5ms, 2});
  CHECK(bench.hands.next_due() == 20ms);
  bench.run(50ms);
  CHECK(bench.heard() == Bytes{0x11, 0x11, 0x22, 0x22});
  CHECK(bench.bytes[2].start == 20ms);
  CHECK(bench.bytes[3].start == 25ms);
  CHECK_FALSE(bench.hands.next_due().has_value());
}
