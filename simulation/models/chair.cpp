#include "simulation/models/chair.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {
namespace {

constexpr double gravity = 9.81;
constexpr double chair_mass = 80;          // kg
constexpr double half_track = 0.56 / 2;    // m
constexpr double gyration_squared = 0.08;  // m2: yaw inertia per kilogram
constexpr double rolling_coefficient = 0.015;
constexpr double castor_friction = 10;  // Nm against turning, dry
constexpr double castor_drag = 3;       // Nm per rad/s
constexpr double full_duty = 511;
constexpr double shorted_coil_current = 3;
constexpr double electronics_current = 0.15;  // A
constexpr double indicator_current = 1.75;
constexpr double headlight_current = 2.5;
constexpr double kerb = 1e6;  // Ns, more than any chair has
constexpr int most_friction_rounds = 30;
constexpr double no_impulse = 1e-10;  // Ns

// Dry friction as an impulse: as much as stops the movement, never more than its limit. Solved in rounds,
// since each row moves the others, until none does; this is what lets the chair stand still exactly.
struct Friction {
  double limit;         // impulse of one step
  double response;      // change of the row's speed by a unit impulse
  double obstacle = 0;  // how much more than `limit` there is against going forward
  double impulse = 0;

  double correct(double speed) {
    const double before = impulse;
    impulse = std::clamp(impulse - speed / response, -limit - obstacle, limit);
    return impulse - before;
  }
};

}  // namespace

Chair::Chair() : lamps_{Lamp(indicator_current), Lamp(indicator_current), Lamp(headlight_current)} {
  state_.battery_volts = battery_.open_circuit();
}

void Chair::step(Time dt) {
  left_brake_.step(lifts(left_damages_, pins_.left_brake_release), dt);
  right_brake_.step(lifts(right_damages_, pins_.right_brake_release), dt);
  state_.left_brake_engaged = left_brake_.is_engaged();
  state_.right_brake_engaged = right_brake_.is_engaged();
  step_loads(dt);
  feed_motors(dt);
  move(seconds(dt));
}

bool Chair::lifts(const Damages& damages, bool is_released) {
  return is_released && !has(damages, Damage::open_coil) && !has(damages, Damage::shorted_coil);
}

Chair::Circuit Chair::circuit(const Damages& damages, bool is_forward, std::uint16_t duty) const {
  if (!pins_.motor_relay || has(damages, Damage::open_motor)) {
    return {};
  }
  if (has(damages, Damage::stuck_bridge)) {
    return {true, 1};
  }
  return pins_.bridge_enable ? Circuit{true, (is_forward ? 1 : -1) * std::min(1.0, duty / full_duty)} : Circuit{};
}

// The bridge is a transformer: duty scales voltage down to the motor and current back to the battery. Solved
// for the sagging terminal voltage at once, as stepping through it would ring.
void Chair::feed_motors(Time dt) {
  const Circuit left_circuit = circuit(left_damages_, pins_.left_forward, pins_.left_duty);
  const Circuit right_circuit = circuit(right_damages_, pins_.right_forward, pins_.right_duty);
  const double left = left_circuit.duty;
  const double right = right_circuit.duty;
  const double emf = left * motor_.back_emf(state_.left_wheel) + right * motor_.back_emf(state_.right_wheel);
  const auto terminals = [&](double resistance) {
    const double ratio = resistance / Motor::resistance;
    const double source = battery_.open_circuit() - resistance * load_current();
    return (source + ratio * emf) / (1 + ratio * (left * left + right * right));
  };
  state_.battery_volts = terminals(Battery::resistance);
  if (state_.battery_volts > battery_.open_circuit()) {  // it is being charged
    state_.battery_volts = terminals(battery_.charging_resistance());
  }
  state_.left_volts = left * state_.battery_volts;
  state_.right_volts = right * state_.battery_volts;
  state_.left_current = left_circuit.is_closed ? motor_.current(state_.left_volts, state_.left_wheel) : 0;
  state_.right_current = right_circuit.is_closed ? motor_.current(state_.right_volts, state_.right_wheel) : 0;
  state_.battery_current = load_current() + left * state_.left_current + right * state_.right_current;
  battery_.discharge(state_.battery_current, seconds(dt));
}

void Chair::move(double dt) {
  const double mass = chair_mass + driver_mass_;
  const double inertia = mass * gyration_squared;
  const double per_mass = 1 / mass;
  const double per_inertia = 1 / inertia;
  const double angle = slope_ * std::numbers::pi / 180;
  const double left_force = motor_.force(state_.left_current);
  const double right_force = motor_.force(state_.right_current);
  double speed = state_.speed + dt * ((left_force + right_force) / mass - gravity * std::sin(angle));
  double turn = state_.turn_rate + dt * (left_force - right_force) * half_track / inertia;
  turn /= 1 + dt * castor_drag / inertia;

  const double rolling = rolling_coefficient * mass * gravity * std::cos(angle) / 2 + Motor::gear_friction;
  const double wheel_response = per_mass + half_track * half_track * per_inertia;
  Friction left{dt * (rolling + left_brake_.friction()), wheel_response,
                has(left_damages_, Damage::blocked_wheel) ? kerb : 0};
  Friction right{dt * (rolling + right_brake_.friction()), wheel_response,
                 has(right_damages_, Damage::blocked_wheel) ? kerb : 0};
  Friction castors{dt * castor_friction, per_inertia};
  for (int round = 0; round < most_friction_rounds; ++round) {
    const double on_left = left.correct(speed + turn * half_track);
    speed += on_left * per_mass;
    turn += on_left * half_track * per_inertia;
    const double on_right = right.correct(speed - turn * half_track);
    speed += on_right * per_mass;
    turn -= on_right * half_track * per_inertia;
    const double on_castors = castors.correct(turn);
    turn += on_castors * per_inertia;
    if (std::abs(on_left) + std::abs(on_right) + std::abs(on_castors) < no_impulse) {
      break;
    }
  }

  constexpr double rest = 1e-9;  // what the rounds leave over
  state_.speed = std::abs(speed) < rest ? 0 : speed;
  state_.turn_rate = std::abs(turn) < rest ? 0 : turn;
  state_.left_wheel = state_.speed + state_.turn_rate * half_track;
  state_.right_wheel = state_.speed - state_.turn_rate * half_track;
  state_.position += state_.speed * dt;
  state_.heading += state_.turn_rate * dt;
}

double Chair::coil_current(const Damages& damages, bool is_released) {
  if (!is_released || has(damages, Damage::open_coil)) {
    return 0;
  }
  return has(damages, Damage::shorted_coil) ? shorted_coil_current : ParkBrake::coil_current;
}

double Chair::coil_current() const {
  return coil_current(left_damages_, pins_.left_brake_release) +
         coil_current(right_damages_, pins_.right_brake_release);
}

void Chair::step_loads(Time dt) {
  actuator1_.step(pins_.actuator1_extend, pins_.actuator1_retract, dt);
  actuator2_.step(pins_.actuator2_extend, pins_.actuator2_retract, dt);
  state_.actuator1_position = actuator1_.position();
  state_.actuator2_position = actuator2_.position();
  state_.left_indicator_current = lamp_current(LampPlace::left_indicator);
  state_.right_indicator_current = lamp_current(LampPlace::right_indicator);
  state_.headlight_current = lamp_current(LampPlace::headlight);
}

double Chair::actuator_current() const {
  return actuator1_.current(pins_.actuator1_extend, pins_.actuator1_retract) +
         actuator2_.current(pins_.actuator2_extend, pins_.actuator2_retract);
}

double Chair::lamp_current(LampPlace place) const {
  const std::array<bool, 3> is_on{pins_.left_indicator, pins_.right_indicator, pins_.headlight};
  const auto number = static_cast<std::size_t>(place);
  return lamps_[number].current(is_on[number]);
}

double Chair::load_current() const {
  return electronics_current + coil_current() + actuator_current() + lamp_current(LampPlace::left_indicator) +
         lamp_current(LampPlace::right_indicator) + lamp_current(LampPlace::headlight);
}

std::array<double, 8> Chair::analog_volts() const {
  std::array<double, 8> volts{state_.battery_volts / 8,
                              2.5 + 0.02 * state_.left_current,
                              2.5 + 0.02 * state_.right_current,
                              coil_current(),
                              lamp_current(LampPlace::left_indicator),
                              lamp_current(LampPlace::right_indicator),
                              lamp_current(LampPlace::headlight),
                              0.2 * actuator_current()};
  for (double& volt : volts) {
    volt = std::clamp(volt, 0.0, 5.0);
  }
  return volts;
}

}  // namespace simulation
