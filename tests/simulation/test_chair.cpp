#include "simulation/models/chair.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace simulation;

Pins released() {
  Pins pins;
  pins.bridge_enable = pins.motor_relay = true;
  pins.left_forward = pins.right_forward = true;
  pins.left_brake_release = pins.right_brake_release = true;
  return pins;
}

Pins driving(std::uint16_t left, std::uint16_t right) {
  Pins pins = released();
  pins.left_duty = left;
  pins.right_duty = right;
  return pins;
}

void run(Chair& chair, const Pins& pins, int ms) {
  chair.apply(pins);
  for (int i = 0; i < ms; ++i) {
    chair.step(1ms);
  }
}

int time_to_rest(Chair& chair, const Pins& pins) {
  int ms = 0;
  while (chair.state().speed != 0 && ms < 60000) {
    run(chair, pins, 1);
    ++ms;
  }
  return ms;
}

}  // namespace

TEST_CASE("Full voltage drives the chair at about 2.8 m/s, straight ahead") {
  Chair chair;
  run(chair, driving(511, 511), 5000);
  CHECK(chair.state().speed == Approx(2.8).margin(0.1));
  CHECK(chair.state().turn_rate == 0);
  CHECK(chair.state().left_current > 1);
  CHECK(chair.state().left_current < 10);
  CHECK(chair.state().position > 10);
}

TEST_CASE("Reverse is as fast as forward with the directions turned round") {
  Chair chair;
  Pins pins = driving(511, 511);
  pins.left_forward = pins.right_forward = false;
  run(chair, pins, 5000);
  CHECK(chair.state().speed == Approx(-2.8).margin(0.1));
  CHECK(chair.state().left_current < -1);
}

TEST_CASE("A stalled motor draws its voltage over its resistance") {
  Chair chair;
  chair.apply(driving(100, 0));
  chair.step(1ms);
  const ChairState& state = chair.state();
  CHECK(state.left_current == Approx(100.0 / 511 * state.battery_volts / 0.15));
  CHECK(state.left_current == Approx(33).margin(1));
  CHECK(state.battery_current == Approx(state.left_current * 100 / 511 + 1.45));
  CHECK(chair.analog_volts()[1] == Approx(2.5 + 0.02 * state.left_current));
  CHECK(chair.analog_volts()[2] == 2.5);
}

TEST_CASE("More on the left wheel turns the chair to the right") {
  Chair chair;
  run(chair, driving(200, 100), 1000);
  CHECK(chair.state().turn_rate > 0.2);
  CHECK(chair.state().left_wheel > chair.state().right_wheel);
  Pins spin = driving(150, 150);
  spin.left_forward = false;
  run(chair, spin, 2000);
  CHECK(chair.state().turn_rate < -0.5);
  CHECK(std::abs(chair.state().speed) < 0.01);
}

TEST_CASE("The springs hold the chair on 10 degrees, and without them it rolls away") {
  Chair chair;
  chair.set_slope(10);
  run(chair, Pins{}, 5000);
  CHECK(chair.state().speed == 0);
  CHECK(chair.state().position == 0);
  Pins pins;
  pins.left_brake_release = pins.right_brake_release = true;
  run(chair, pins, 1000);
  CHECK(chair.state().speed < -0.5);
}

TEST_CASE("Brakes lift after 60 ms and fall after 40 ms") {
  Chair chair;
  run(chair, released(), 59);
  CHECK(chair.state().left_brake_engaged);
  CHECK(chair.analog_volts()[3] == Approx(1.3));
  run(chair, released(), 1);
  CHECK_FALSE(chair.state().left_brake_engaged);
  Pins pins = released();
  pins.left_brake_release = false;
  run(chair, pins, 39);
  CHECK_FALSE(chair.state().left_brake_engaged);
  run(chair, pins, 1);
  CHECK(chair.state().left_brake_engaged);
  CHECK_FALSE(chair.state().right_brake_engaged);
}

TEST_CASE("Shorted motors stop the chair sooner than coasting, and stand still exactly") {
  Chair shorted;
  Chair coasting;
  run(shorted, driving(511, 511), 3000);
  run(coasting, driving(511, 511), 3000);
  Pins open = released();
  SECTION("bridge off") {
    open.bridge_enable = false;
  }
  SECTION("relay off") {
    open.motor_relay = false;
  }
  open.left_duty = open.right_duty = 511;
  const int short_stop = time_to_rest(shorted, released());
  const int long_stop = time_to_rest(coasting, open);
  CHECK(short_stop > 200);
  CHECK(short_stop < 1500);
  CHECK(long_stop > 5000);
  CHECK(long_stop < 20000);
  CHECK(coasting.state().left_current == 0);
  const double rest = shorted.state().position;
  run(shorted, released(), 1000);
  CHECK(shorted.state().position == rest);
}

TEST_CASE("The battery pin shows an eighth of what is there") {
  Chair chair;
  CHECK(chair.analog_volts()[0] == Approx(25.4 / 8));
  chair.set_battery_voltage(18);
  run(chair, Pins{}, 1);
  CHECK(chair.analog_volts()[0] == Approx(18.0 / 8).margin(0.01));
}

TEST_CASE("Lamps and actuators draw their currents") {
  Chair chair;
  Pins pins;
  pins.left_indicator = pins.headlight = pins.actuator1_extend = true;
  run(chair, pins, 1);
  CHECK(chair.analog_volts()[4] == 1.75);
  CHECK(chair.analog_volts()[5] == 0);
  CHECK(chair.analog_volts()[6] == 2.5);
  CHECK(chair.analog_volts()[7] == Approx(0.8));
}

TEST_CASE("A heavier driver takes longer to get going") {
  Chair light;
  Chair heavy;
  heavy.set_driver_mass(160);
  run(light, driving(300, 300), 300);
  run(heavy, driving(300, 300), 300);
  CHECK(heavy.state().speed < light.state().speed);
}

TEST_CASE("A coil that is off or shorted lifts nothing, and the sensor of both shows it", "[H-13]") {
  const auto sensor = [](Damage damage, Side side) {
    Chair chair;
    chair.set_damage(damage, side, true);
    run(chair, released(), 100);
    CHECK(chair.state().left_brake_engaged == (side == Side::left));
    CHECK(chair.state().right_brake_engaged == (side == Side::right));
    return chair.analog_volts()[3];
  };
  CHECK(sensor(Damage::open_coil, Side::left) == Approx(0.65));
  CHECK(sensor(Damage::open_coil, Side::right) == Approx(0.65));
  CHECK(sensor(Damage::shorted_coil, Side::left) == Approx(3.65));
  CHECK(sensor(Damage::shorted_coil, Side::right) == Approx(3.65));
}

TEST_CASE("A stuck bridge drives its motor whatever the pins say, until the relay opens", "[H-10]") {
  Chair chair;
  chair.set_damage(Damage::stuck_bridge, Side::right, true);
  Pins pins;
  run(chair, pins, 100);
  CHECK(chair.state().right_current == 0);
  pins.motor_relay = true;
  run(chair, pins, 10);
  CHECK(chair.state().right_current > 80);
  CHECK(chair.state().left_current == 0);
  pins.motor_relay = false;
  run(chair, pins, 1);
  CHECK(chair.state().right_current == 0);
  pins.motor_relay = true;
  chair.set_damage(Damage::stuck_bridge, Side::right, false);
  run(chair, pins, 1);
  CHECK(chair.state().right_current == 0);
}

TEST_CASE("A motor whose wire is off has no current, and the chair turns to its side", "[H-10]") {
  Chair chair;
  chair.set_damage(Damage::open_motor, Side::left, true);
  run(chair, driving(300, 300), 1000);
  CHECK(chair.state().left_current == 0);
  CHECK(chair.state().right_current > 1);
  CHECK(chair.state().turn_rate < 0);
}
