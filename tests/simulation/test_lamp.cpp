#include "simulation/models/lamp.hpp"

#include <catch2/catch.hpp>

#include "simulation/models/chair.hpp"

namespace {

using namespace simulation;

Pins lit() {
  Pins pins;
  pins.left_indicator = pins.right_indicator = pins.headlight = true;
  return pins;
}

}  // namespace

TEST_CASE("A lamp draws its current while it is on", "[negotiation]") {
  const Lamp lamp(1.75);
  CHECK(lamp.current(true) == 1.75);
  CHECK(lamp.current(false) == 0);
}

TEST_CASE("A lamp whose wire is off draws nothing, a shorted one 8 A, both nothing while off", "[negotiation]") {
  Lamp lamp(2.5);
  lamp.set_damage(LampDamage::shorted, true);
  CHECK(lamp.current(true) == 8);
  CHECK(lamp.current(false) == 0);
  lamp.set_damage(LampDamage::open, true);
  CHECK(lamp.current(true) == 0);
  lamp.set_damage(LampDamage::open, false);
  lamp.set_damage(LampDamage::shorted, false);
  CHECK(lamp.current(true) == 2.5);
}

TEST_CASE("Each lamp's sensor shows its own lamp, and not more than 5 V", "[negotiation]") {
  Chair chair;
  chair.lamp(LampPlace::left_indicator).set_damage(LampDamage::open, true);
  chair.lamp(LampPlace::headlight).set_damage(LampDamage::shorted, true);
  chair.apply(lit());
  chair.step(1ms);
  CHECK(chair.analog_volts()[4] == 0);
  CHECK(chair.analog_volts()[5] == 1.75);
  CHECK(chair.analog_volts()[6] == 5);
  CHECK(chair.state().left_indicator_current == 0);
  CHECK(chair.state().right_indicator_current == 1.75);
  CHECK(chair.state().headlight_current == 8);
}

TEST_CASE("The battery feeds the lamps", "[negotiation]") {
  Chair chair;
  chair.step(1ms);
  const double dark = chair.state().battery_current;
  chair.apply(lit());
  chair.step(1ms);
  CHECK(chair.state().battery_current == Approx(dark + 1.75 + 1.75 + 2.5));
  chair.lamp(LampPlace::right_indicator).set_damage(LampDamage::shorted, true);
  chair.step(1ms);
  CHECK(chair.state().battery_current == Approx(dark + 1.75 + 8 + 2.5));
  CHECK(chair.state().battery_volts == Approx(25.4 - 0.05 * (dark + 12.25)).margin(0.001));
}
