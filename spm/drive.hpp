// From the stick to what each wheel is asked to do: deadband and scale, speed pot, maxima, mixing, ramps.
//
//   stick --rest?--> axis share --pot, maxima--> forward, turn --mix, ceiling--> targets --ramps--> demand
//
// Shares and demands are signed fractions of full motor voltage, +-16384 = all of it (Q14). Between the
// milliseconds a demand keeps 8 more bits, so that slow ramps do not round away.
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
};

// A driver's command as it came over the bus.
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
  uint16_t speedo_gain;  // demand to 0..31 of the forward maximum, times 2^17
  int32_t acceleration;  // Q22 per millisecond from here on
  int32_t forward_deceleration;
  int32_t reverse_deceleration;
  int32_t emergency_deceleration;
};

DriveProfile make_profile(const Settings& settings);

// Both axes inside the deadband (SB-01.8).
bool is_at_rest(const Stick& stick, const DriveProfile& profile);

// What the wheels should do in the end, ramps aside.
Wheels targets_of(const Stick& stick, const DriveProfile& profile, bool is_limping);

// The speed of the chair's middle on the bus's scale, 31 = the profile's maximum whatever the pot says (SB-01.7).
uint8_t speedo_of(const Wheels& demand, const DriveProfile& profile);

// Brings two wheels towards their targets, a millisecond at a time.
class Ramps {
 public:
  constexpr Ramps() : left_(0), right_(0) {}

  void step(const Wheels& targets, const DriveProfile& profile);
  // Towards zero and nowhere else, at the emergency rate (SB-2.17).
  void stop(const DriveProfile& profile);
  // As after a start: no motion.
  void clear() { left_ = right_ = 0; }

  Wheels demand() const;

 private:
  int32_t left_;  // Q22
  int32_t right_;
};

}  // namespace spm
