// The body around the power module: battery, two motors, brakes, lamps, actuators, chair and driver on the
// ground. Pins go in, movement and the eight analog voltages come out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simulation/board/spm_board.hpp"
#include "simulation/models/actuator.hpp"
#include "simulation/models/battery.hpp"
#include "simulation/models/lamp.hpp"
#include "simulation/models/motor.hpp"
#include "simulation/models/park_brake.hpp"
#include "simulation/time.hpp"

namespace simulation {

struct ChairState {
  double speed = 0;       // m/s over ground, forward positive
  double turn_rate = 0;   // rad/s, to the right positive
  double position = 0;    // m along the way, forward positive
  double heading = 0;     // rad, to the right positive
  double left_wheel = 0;  // m/s at the tread, forward positive
  double right_wheel = 0;
  double left_current = 0;  // A, forward positive
  double right_current = 0;
  double left_volts = 0;  // at the motor; 0 also while its circuit is open
  double right_volts = 0;
  double battery_volts = 0;    // at the terminals
  double battery_current = 0;  // A, out of the battery
  bool left_brake_engaged = true;
  bool right_brake_engaged = true;
  double actuator1_position = 0.5;  // 0 = retracted, 1 = extended
  double actuator2_position = 0.5;
  double left_indicator_current = 0;  // A
  double right_indicator_current = 0;
  double headlight_current = 0;
};

enum class Side : std::uint8_t { left, right };

// What can be broken on one side; anything of it, both sides at once, and nothing at first.
enum class Damage : std::uint8_t {
  open_coil,      // the wire of the park brake's coil is off: no current, the brake stays engaged
  shorted_coil,   // it draws far too much and lifts nothing
  stuck_bridge,   // the motor has the full supply, forward, while the relay is closed
  open_motor,     // the motor's wire is off: no current
  blocked_wheel,  // it stands against a kerb: it cannot turn forward, backward it can
};

class Chair {
 public:
  Chair();

  void apply(const Pins& pins) { pins_ = pins; }
  void step(Time dt);  // 1 ms; stable up to several

  const ChairState& state() const { return state_; }
  std::array<double, 8> analog_volts() const;  // ADC0 first, 0 to 5 V

  void set_slope(double degrees) { slope_ = degrees; }  // rises ahead of the chair: positive
  void set_driver_mass(double kilograms) { driver_mass_ = kilograms; }
  void set_battery_voltage(double volts) { battery_.force_open_circuit(volts); }
  void set_battery(double volts) { set_battery_voltage(volts); }
  void set_damage(Damage damage, Side side, bool is_there) { damage_of(side)[index_of(damage)] = is_there; }
  Lamp& lamp(LampPlace place) { return lamps_[static_cast<std::size_t>(place)]; }
  Actuator& actuator(int number) { return number == 2 ? actuator2_ : actuator1_; }  // 1 or 2
  void set_position(double metres) { state_.position = metres; }

 private:
  using Damages = std::array<bool, 5>;

  // What connects a motor to the supply: nothing, or a bridge with its duty.
  struct Circuit {
    bool is_closed = false;
    double duty = 0;
  };

  static std::size_t index_of(Damage damage) { return static_cast<std::size_t>(damage); }
  Damages& damage_of(Side side) { return side == Side::left ? left_damages_ : right_damages_; }
  static bool has(const Damages& damages, Damage damage) { return damages[index_of(damage)]; }
  static bool lifts(const Damages& damages, bool is_released);
  static double coil_current(const Damages& damages, bool is_released);

  Circuit circuit(const Damages& damages, bool is_forward, std::uint16_t duty) const;
  double coil_current() const;
  double actuator_current() const;
  double lamp_current(LampPlace place) const;
  double load_current() const;
  void step_loads(Time dt);
  void feed_motors(Time dt);
  void move(double dt);

  Pins pins_;
  Damages left_damages_{};
  Damages right_damages_{};
  ChairState state_;
  Battery battery_;
  Motor motor_;  // both are alike
  ParkBrake left_brake_;
  ParkBrake right_brake_;
  std::array<Lamp, 3> lamps_;
  Actuator actuator1_;
  Actuator actuator2_;
  double slope_ = 0;
  double driver_mass_ = 100;
};

}  // namespace simulation
