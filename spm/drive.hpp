// From the stick to what each wheel is asked to do: deadband and scale, speed pot, maxima, ramps, mixing.
//
//   stick --deadband--> axis shares --maxima, pot, ceiling--> command --ramps--> command of this millisecond
//                                                                      --mix--> demand of each wheel
//
// Forward and turn are ramped apart, before they are mixed: a chair steers as quickly as its turn ramp says, however
// slowly it gathers speed.
//
// Shares and demands are signed fractions of full motor voltage, +-16384 = all of it (Q14). Ramps' rates are 1/256 of
// such a step a millisecond; what is less than a step waits in a byte for the next one, so that slow ramps do not
// round away and 16 bits are enough.
#pragma once

#include <stdint.h>

#include "bus/shark/packets.hpp"
#include "spm/outputs.hpp"
#include "spm/settings.hpp"

namespace spm {

struct Wheels {
  Demand left;
  Demand right;

  constexpr bool is_zero() const { return left == Demand(0) && right == Demand(0); }
  constexpr bool operator==(const Wheels& other) const { return left == other.left && right == other.right; }
  constexpr bool operator!=(const Wheels& other) const { return !(*this == other); }
};

// What is asked of the chair as a whole, in Q14: forward positive, to the right positive. Both together never exceed
// full motor voltage, so neither wheel does.
struct Command {
  int16_t forward = 0;
  int16_t turn = 0;

  constexpr bool is_zero() const { return forward == 0 && turn == 0; }
};

constexpr Wheels mix(const Command& command) {
  return Wheels{Demand(static_cast<int16_t>(command.forward + command.turn)),
                Demand(static_cast<int16_t>(command.forward - command.turn))};
}

// A driver's wish as it came over the bus.
struct Stick {
  bus::shark::JoystickReading speed = bus::shark::joystick_neutral;
  bus::shark::JoystickReading direction = bus::shark::joystick_neutral;
  bus::shark::PotReading pot;
};

// Settings turned into the numbers that the sums need; made once, whenever settings change.
struct DriveProfile {
  uint16_t deadband;
  uint16_t travel;     // counts beyond the deadband that make full deflection
  uint16_t axis_gain;  // Q14 share per count, times 16
  int16_t pot_floor;   // Q14 from here on
  int16_t forward_maximum;
  int16_t reverse_maximum;
  int16_t turn_maximum;
  int16_t limp_maximum;
  uint16_t speedo_gain;   // demand to 0..31 of the forward maximum, times 2^17
  uint16_t acceleration;  // 1/256 of a Q14 step per millisecond from here on
  uint16_t forward_deceleration;
  uint16_t reverse_deceleration;
  uint16_t turn_acceleration;
  uint16_t turn_deceleration;
  uint16_t emergency_deceleration;
};

DriveProfile make_profile(const Settings& settings);

// Both axes inside the deadband (SB-01.8).
bool is_at_rest(const Stick& stick, const DriveProfile& profile);

// What the chair should do in the end, ramps aside. Forward and turn together stay below `most`, and limping below
// LIMP's ceiling.
Command command_of(const Stick& stick, const DriveProfile& profile, bool is_limping, Demand most = full_demand);

// `part` of `whole` as a byte, rounded up, and its opposite; 0 <= part <= whole <= 16384. A share of 1 is 255/256 here.
uint8_t byte_share(int16_t part, int16_t whole);
int16_t scaled(int16_t whole, uint8_t share);

// The speed of the chair's middle on the bus's scale, 31 = the profile's maximum whatever the pot says (SB-01.7).
uint8_t speedo_of(const Wheels& demand, const DriveProfile& profile);

// One signed value on its way to a target.
//
// Invariants: it passes zero when it changes its sign, and it never overshoots.
class Ramp {
 public:
  constexpr int16_t value() const { return value_; }
  // At once, without a ramp.
  void put(int16_t value) { value_ = value; }
  // One millisecond: away from zero at `rise`, towards it at `drop`.
  void approach(int16_t target, uint16_t rise, uint16_t drop) {
    const bool is_upwards = target > value_;
    const bool is_rising = is_upwards ? value_ >= 0 : value_ <= 0;  // away from zero
    const int16_t bound = !is_rising && (value_ < 0) != (target < 0) ? int16_t{0} : target;
    const int16_t step = take_step(is_rising ? rise : drop);
    const int16_t next = static_cast<int16_t>(is_upwards ? value_ + step : value_ - step);
    value_ = (is_upwards ? next > bound : next < bound) ? bound : next;
  }
  // One millisecond towards zero.
  void fall(uint16_t rate);

 private:
  int16_t take_step(uint16_t rate) {
    const uint16_t sum = static_cast<uint16_t>(rate + fraction_);
    fraction_ = static_cast<uint8_t>(sum & 0xFF);
    return static_cast<int16_t>(sum >> 8);
  }

  int16_t value_ = 0;
  uint8_t fraction_ = 0;  // 1/256 of a step, not yet made
};

// Brings the chair towards its command, a millisecond at a time.
//
// Invariants: forward and turn together never exceed full motor voltage; the wheels change by no more than both ramps'
// steps, or twice the turn's where the speed has to make room for it.
class Ramps {
 public:
  void aim_at(const Command& command);

  // Towards the command. If full voltage is not enough for both, speed gives way before the turn does. Until the chair
  // is as fast as it was asked to be, the turn grows no further than in proportion to the speed: so from rest it begins
  // with the curve that was asked for, neither straight on nor on the spot. Towards neutral it keeps its curve, so no
  // wheel grows (H-03).
  void step(const DriveProfile& profile);
  // Towards zero and nowhere else, at the emergency rate (SB-2.17): the larger of forward and turn, and the other in
  // proportion. So the chair keeps its curve, no wheel grows or changes its sign, and both stand still together.
  void stop(const DriveProfile& profile);
  // The wheels got `granted`, which is nearer to zero than what was asked for: ramp on from there (H-33).
  void yield_to(const Wheels& granted);
  // The same, whatever they were before, to a step (H-27).
  void resume(const Wheels& granted);
  // No motion, as after a start.
  void clear() {
    forward_ = turn_ = Ramp();
    is_falling_ = false;
  }

  const Command& target() const { return target_; }
  Wheels demand() const { return mix(Command{forward_.value(), turn_.value()}); }

 private:
  void approach_turn(const DriveProfile& profile);
  // Neither faster than its own rate allows.
  void fall_together(uint16_t forward_rate, uint16_t turn_rate);

  Command target_;
  Ramp forward_;
  Ramp turn_;
  uint8_t curve_ = 0;  // the smaller of the target's forward and turn as a share of the larger, times 256
  bool is_mostly_turn_ = false;
  bool is_falling_ = false;
  int16_t proportion_ = 0;  // Q14, while both fall: the smaller of both as a share of the larger
};

}  // namespace spm
