#include "simulation/models/actuator.hpp"

#include <catch2/catch.hpp>

#include "simulation/models/chair.hpp"

namespace {

using namespace simulation;

void extend(Actuator& actuator, int ms) {
  for (int i = 0; i < ms; ++i) {
    actuator.step(true, false, 1ms);
  }
}

void retract(Actuator& actuator, int ms) {
  for (int i = 0; i < ms; ++i) {
    actuator.step(false, true, 1ms);
  }
}

Actuator damaged(ActuatorDamage damage) {
  Actuator actuator;
  actuator.set_damage(damage, true);
  return actuator;
}

}  // namespace

TEST_CASE("An actuator goes from end to end in 10 s, from the middle of its travel at first", "[negotiation]") {
  Actuator actuator;
  CHECK(actuator.position() == 0.5);
  extend(actuator, 1000);
  CHECK(actuator.position() == Approx(0.6));
  extend(actuator, 3999);
  CHECK(actuator.position() < 1);
  extend(actuator, 1);
  CHECK(actuator.position() == 1);
  retract(actuator, 9999);
  CHECK(actuator.position() == Approx(0.0001));
  retract(actuator, 1);
  CHECK(actuator.position() == 0);
  retract(actuator, 5000);
  extend(actuator, 2500);
  CHECK(actuator.position() == Approx(0.25));
}

TEST_CASE("It draws 4 A while it moves, and nothing without or with both outputs", "[negotiation]") {
  Actuator actuator;
  CHECK(actuator.current(true, false) == 4);
  CHECK(actuator.current(false, true) == 4);
  CHECK(actuator.current(false, false) == 0);
  CHECK(actuator.current(true, true) == 0);
  actuator.step(true, true, 1s);
  actuator.step(false, false, 1s);
  CHECK(actuator.position() == 0.5);
}

TEST_CASE("An end switch cuts the current for its own direction only", "[negotiation]") {
  Actuator actuator;
  extend(actuator, 5000);
  CHECK(actuator.current(true, false) == 0);
  CHECK(actuator.current(false, true) == 4);
  retract(actuator, 1);
  CHECK(actuator.current(true, false) == 4);
  retract(actuator, 9999);
  CHECK(actuator.current(false, true) == 0);
  CHECK(actuator.current(true, false) == 4);
}

TEST_CASE("Without end switches it stalls with 9 A at the end, and comes back", "[negotiation]") {
  Actuator actuator = damaged(ActuatorDamage::no_end_switch);
  CHECK(actuator.current(true, false) == 4);
  extend(actuator, 6000);
  CHECK(actuator.position() == 1);
  CHECK(actuator.current(true, false) == 9);
  CHECK(actuator.current(false, true) == 4);
  retract(actuator, 11000);
  CHECK(actuator.position() == 0);
  CHECK(actuator.current(false, true) == 9);
}

TEST_CASE("A blocked actuator stalls with 9 A where it is", "[negotiation]") {
  Actuator actuator = damaged(ActuatorDamage::blocked);
  CHECK(actuator.current(true, false) == 9);
  CHECK(actuator.current(false, true) == 9);
  CHECK(actuator.current(false, false) == 0);
  extend(actuator, 1000);
  CHECK(actuator.position() == 0.5);
  actuator.set_damage(ActuatorDamage::blocked, false);
  extend(actuator, 1000);
  CHECK(actuator.position() == Approx(0.6));
}

TEST_CASE("A shorted actuator draws 20 A, one whose wire is off nothing; neither moves", "[negotiation]") {
  Actuator actuator = damaged(ActuatorDamage::shorted);
  CHECK(actuator.current(false, true) == 20);
  CHECK(actuator.current(false, false) == 0);
  retract(actuator, 1000);
  CHECK(actuator.position() == 0.5);
  actuator.set_damage(ActuatorDamage::open, true);
  CHECK(actuator.current(false, true) == 0);
  actuator.set_damage(ActuatorDamage::shorted, false);
  CHECK(actuator.current(false, true) == 0);
  retract(actuator, 1000);
  CHECK(actuator.position() == 0.5);
}

TEST_CASE("On the chair each pin moves its actuator its way, and one sensor shows both", "[negotiation]") {
  Chair chair;
  Pins pins;
  pins.actuator1_extend = pins.actuator2_retract = true;
  chair.apply(pins);
  for (int i = 0; i < 2000; ++i) {
    chair.step(1ms);
  }
  CHECK(chair.state().actuator1_position == Approx(0.7));
  CHECK(chair.state().actuator2_position == Approx(0.3));
  CHECK(chair.analog_volts()[7] == Approx(1.6));
  CHECK(chair.state().battery_current == Approx(8.15));
  pins.actuator1_extend = pins.actuator2_retract = false;
  pins.actuator1_retract = true;
  chair.apply(pins);
  for (int i = 0; i < 1000; ++i) {
    chair.step(1ms);
  }
  CHECK(chair.state().actuator1_position == Approx(0.6));
  CHECK(chair.state().actuator2_position == Approx(0.3));
  CHECK(chair.analog_volts()[7] == Approx(0.8));
}

TEST_CASE("The sensor of both actuators shows a stall and a short, and not more than 5 V", "[negotiation]") {
  Chair chair;
  Pins pins;
  pins.actuator1_extend = pins.actuator2_extend = true;
  chair.apply(pins);
  chair.actuator(1).set_damage(ActuatorDamage::blocked, true);
  CHECK(chair.analog_volts()[7] == Approx(2.6));
  chair.actuator(2).set_damage(ActuatorDamage::shorted, true);
  CHECK(chair.analog_volts()[7] == 5);
  chair.actuator(1).set_damage(ActuatorDamage::open, true);
  CHECK(chair.analog_volts()[7] == Approx(4));
}
