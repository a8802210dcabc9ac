#include "spm/drive.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::magnitude;
using bus::shark::JoystickReading;

namespace {

constexpr uint8_t ramp_bits = 8;  // below a Q14 demand
constexpr int32_t full = full_demand.count();

int16_t share_of(uint16_t permille) {
  return static_cast<int16_t>((static_cast<int32_t>(permille) * full + 500) / 1000);
}

// Permille a second into Q22 a millisecond; never 0, or a ramp would stand still.
int32_t rate_of(uint16_t permille_per_second) {
  const int32_t rate = (static_cast<int32_t>(permille_per_second) * ((full << ramp_bits) / 1000) + 500) / 1000;
  return rate > 0 ? rate : 1;
}

// Shifts on magnitudes, here and below: they round towards zero like a division, which the AVR would do bit by bit.
constexpr int16_t times(int16_t share, int16_t other) {
  const uint32_t product =
      static_cast<uint32_t>(static_cast<uint16_t>(magnitude(share))) * static_cast<uint16_t>(magnitude(other));
  const int16_t scaled = static_cast<int16_t>((product << 2) >> 16);
  return static_cast<int16_t>((share < 0) != (other < 0) ? -scaled : scaled);
}
static_assert(full == int32_t{1} << 14, "a share of 2^14, times 4, stands in the upper half");

constexpr int16_t without_ramp_bits(int32_t value) {
  return static_cast<int16_t>(value < 0 ? -(-value >> ramp_bits) : value >> ramp_bits);
}

int16_t off_neutral(JoystickReading reading) {
  return static_cast<int16_t>(static_cast<int16_t>(reading.count()) -
                              static_cast<int16_t>(bus::shark::joystick_neutral.count()));
}

bool is_axis_at_rest(JoystickReading reading, const DriveProfile& profile) {
  return static_cast<uint16_t>(magnitude(off_neutral(reading))) <= profile.deadband;
}

// SB-00.8: zero inside the deadband, rising from zero at its edge, full at the end of travel.
int16_t axis_share(JoystickReading reading, const DriveProfile& profile) {
  if (is_axis_at_rest(reading, profile)) {
    return 0;
  }
  const int16_t offset = off_neutral(reading);
  const uint16_t beyond = static_cast<uint16_t>(static_cast<uint16_t>(magnitude(offset)) - profile.deadband);
  int16_t share = static_cast<int16_t>(full);
  if (beyond < profile.travel) {
    share = static_cast<int16_t>((static_cast<uint32_t>(beyond) * profile.axis_gain) >> 4);
  }
  return static_cast<int16_t>(offset < 0 ? -share : share);
}

int16_t pot_share(bus::shark::PotReading pot, const DriveProfile& profile) {
  const int32_t above_floor = full - profile.pot_floor;
  // x * pot / 255 without a division, exact at both ends.
  return static_cast<int16_t>(profile.pot_floor +
                              ((above_floor * (static_cast<int32_t>(pot.count()) * 257) + above_floor) >> 16));
}

// Keeps both wheels within the ceiling; speed gives way before the turn does.
Wheels mix(int16_t forward, int16_t turn, int16_t ceiling) {
  if (magnitude(turn) > ceiling) {
    turn = static_cast<int16_t>(turn < 0 ? -ceiling : ceiling);
  }
  const int16_t room = static_cast<int16_t>(ceiling - magnitude(turn));
  if (magnitude(forward) > room) {
    forward = static_cast<int16_t>(forward < 0 ? -room : room);
  }
  return Wheels{Demand(static_cast<int16_t>(forward + turn)), Demand(static_cast<int16_t>(forward - turn))};
}

int32_t fall(int32_t value, int32_t floor, int32_t rate) {
  return value - floor > rate ? value - rate : floor;
}

// For a wheel that turns forward or stands: down to the target, or to zero if that lies behind it.
int32_t approach(int32_t value, int32_t target, int32_t rise, int32_t drop) {
  if (value < 0 || (value == 0 && target < 0)) {
    return -approach(-value, -target, rise, drop);
  }
  if (target >= value) {
    return target - value > rise ? value + rise : target;
  }
  return fall(value, target > 0 ? target : 0, drop);
}

}  // namespace

DriveProfile make_profile(const Settings& settings) {
  DriveProfile profile;
  profile.deadband = settings[Setting::deadband];
  profile.travel = static_cast<uint16_t>(settings[Setting::stick_travel] - profile.deadband);
  profile.axis_gain = static_cast<uint16_t>((static_cast<uint32_t>(full) << 4) / profile.travel);
  profile.pot_floor = share_of(settings[Setting::pot_floor]);
  profile.forward_maximum = share_of(settings[Setting::forward_maximum]);
  profile.reverse_maximum = share_of(settings[Setting::reverse_maximum]);
  profile.turn_maximum = share_of(settings[Setting::turn_maximum]);
  profile.limp_maximum = times(share_of(settings[Setting::limp_maximum]), profile.forward_maximum);  // SB-2.16
  profile.speedo_gain = static_cast<uint16_t>((static_cast<uint32_t>(limits::speedo_full) << 17) /
                                              static_cast<uint16_t>(profile.forward_maximum));
  profile.acceleration = rate_of(settings[Setting::acceleration]);
  profile.forward_deceleration = rate_of(settings[Setting::forward_deceleration]);
  profile.reverse_deceleration = rate_of(settings[Setting::reverse_deceleration]);
  profile.emergency_deceleration = rate_of(settings[Setting::emergency_deceleration]);
  return profile;
}

bool is_at_rest(const Stick& stick, const DriveProfile& profile) {
  return is_axis_at_rest(stick.speed, profile) && is_axis_at_rest(stick.direction, profile);
}

Wheels targets_of(const Stick& stick, const DriveProfile& profile, bool is_limping) {
  const int16_t pot = pot_share(stick.pot, profile);
  const int16_t speed = axis_share(stick.speed, profile);
  const int16_t maximum = speed < 0 ? profile.reverse_maximum : profile.forward_maximum;
  const int16_t forward = times(times(speed, maximum), pot);
  const int16_t turn = times(times(axis_share(stick.direction, profile), profile.turn_maximum), pot);
  return mix(forward, turn,
             is_limping ? profile.limp_maximum : static_cast<int16_t>(full));  // SB-2.16: a cap, no scale
}

uint8_t speedo_of(const Wheels& demand, const DriveProfile& profile) {
  const int32_t both = static_cast<int32_t>(demand.left.count()) + demand.right.count();
  const uint16_t middle = static_cast<uint16_t>((both < 0 ? -both : both) >> 1);
  const uint32_t shown = (static_cast<uint32_t>(middle) * profile.speedo_gain + (uint32_t{1} << 16)) >> 17;
  return shown > limits::speedo_full ? limits::speedo_full : static_cast<uint8_t>(shown);
}

void Ramps::step(const Wheels& targets, const DriveProfile& profile) {
  // One rate for both wheels, or a turn would bend while it ends.
  const bool is_reversing = left_ + right_ < 0;
  const int32_t drop = is_reversing ? profile.reverse_deceleration : profile.forward_deceleration;
  left_ = approach(left_, static_cast<int32_t>(targets.left.count()) * (1 << ramp_bits), profile.acceleration, drop);
  right_ = approach(right_, static_cast<int32_t>(targets.right.count()) * (1 << ramp_bits), profile.acceleration, drop);
}

void Ramps::stop(const DriveProfile& profile) {
  left_ = approach(left_, 0, 0, profile.emergency_deceleration);
  right_ = approach(right_, 0, 0, profile.emergency_deceleration);
}

Wheels Ramps::demand() const {
  return Wheels{Demand(without_ramp_bits(left_)), Demand(without_ramp_bits(right_))};
}

}  // namespace spm
