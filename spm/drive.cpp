#include "spm/drive.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::magnitude;
using bus::shark::JoystickReading;

namespace {

constexpr int32_t full = full_demand.count();

int16_t share_of(uint16_t permille) {
  return static_cast<int16_t>((static_cast<int32_t>(permille) * full + 500) / 1000);
}

// Permille a second into 1/256 Q14 a millisecond, to the nearest: 2^14 * 256 / 10^6 = 2^18 / 62500.
uint16_t rate_of(uint16_t permille_per_second) {
  return static_cast<uint16_t>(((static_cast<uint32_t>(permille_per_second) << 18) + 31250) / 62500);
}

// Shifts on magnitudes: they round towards zero like a division, which the AVR would do bit by bit.
constexpr int16_t times(int16_t share, int16_t other) {
  const uint32_t product =
      static_cast<uint32_t>(static_cast<uint16_t>(magnitude(share))) * static_cast<uint16_t>(magnitude(other));
  const int16_t result = static_cast<int16_t>((product << 2) >> 16);
  return static_cast<int16_t>((share < 0) != (other < 0) ? -result : result);
}
static_assert(full == int32_t{1} << 14, "a share of 2^14, times 4, stands in the upper half");

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

int16_t limited(int16_t value, int16_t most) {
  if (magnitude(value) <= most) {
    return value;
  }
  return static_cast<int16_t>(value < 0 ? -most : most);
}

// `part` of `whole`, times 2^bits, rounded up; 0 <= part <= whole <= 16384, whole > 0, at most 14 bits. A bit at a
// time: the AVR has no division, and the compiler's is for any numbers.
int16_t proportion_of(int16_t part, int16_t whole, uint8_t bits) {
  int16_t quotient = part < whole ? int16_t{0} : int16_t{1};
  int16_t rest = part < whole ? part : int16_t{0};
  for (; bits > 0; --bits) {
    rest = static_cast<int16_t>(rest * 2);
    quotient = static_cast<int16_t>(quotient * 2);
    if (rest >= whole) {
      rest = static_cast<int16_t>(rest - whole);
      ++quotient;
    }
  }
  return static_cast<int16_t>(rest != 0 ? quotient + 1 : quotient);
}

}  // namespace

uint8_t byte_share(int16_t part, int16_t whole) {
  const int16_t share = whole > 0 ? proportion_of(part, whole, 8) : int16_t{0};
  return static_cast<uint8_t>(share > 255 ? 255 : share);
}

int16_t scaled(int16_t whole, uint8_t share) {
  // Two small products: 8 bits times 8 is one instruction of the AVR, 16 times 16 is a call.
  const uint16_t of_high = static_cast<uint8_t>(whole >> 8) * uint16_t{share};
  const uint16_t of_low = static_cast<uint8_t>(whole & 0xFF) * uint16_t{share};
  return static_cast<int16_t>(of_high + (of_low >> 8));
}

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
  profile.turn_acceleration = rate_of(settings[Setting::turn_acceleration]);
  profile.turn_deceleration = rate_of(settings[Setting::turn_deceleration]);
  profile.emergency_deceleration = rate_of(settings[Setting::emergency_deceleration]);
  return profile;
}

bool is_at_rest(const Stick& stick, const DriveProfile& profile) {
  return is_axis_at_rest(stick.speed, profile) && is_axis_at_rest(stick.direction, profile);
}

// Not inlined: what is done with every general must not cost the other milliseconds registers.
__attribute__((noinline)) Command command_of(const Stick& stick, const DriveProfile& profile, bool is_limping,
                                             Demand most) {
  const int16_t pot = pot_share(stick.pot, profile);
  const int16_t speed = axis_share(stick.speed, profile);
  const int16_t maximum = speed < 0 ? profile.reverse_maximum : profile.forward_maximum;
  // SB-2.16: a cap, no scale
  const int16_t own = is_limping ? profile.limp_maximum : static_cast<int16_t>(full);
  // H-27: a ceiling below zero, which no battery has, would be a command.
  const int16_t ceiling = most < Demand(0) ? int16_t{0} : most.count() < own ? most.count() : own;
  Command command;
  command.turn = limited(times(times(axis_share(stick.direction, profile), profile.turn_maximum), pot), ceiling);
  // Speed gives way before the turn does.
  command.forward = limited(times(times(speed, maximum), pot), static_cast<int16_t>(ceiling - magnitude(command.turn)));
  return command;
}

uint8_t speedo_of(const Wheels& demand, const DriveProfile& profile) {
  const int32_t both = static_cast<int32_t>(demand.left.count()) + demand.right.count();
  const uint16_t middle = static_cast<uint16_t>((both < 0 ? -both : both) >> 1);
  const uint32_t shown = (static_cast<uint32_t>(middle) * profile.speedo_gain + (uint32_t{1} << 16)) >> 17;
  return shown > limits::speedo_full ? limits::speedo_full : static_cast<uint8_t>(shown);
}

void Ramp::fall(uint16_t rate) {
  const int16_t step = take_step(rate);
  if (magnitude(value_) <= step) {
    value_ = 0;
  } else {
    value_ = static_cast<int16_t>(value_ < 0 ? value_ + step : value_ - step);
  }
}

void Ramps::aim_at(const Command& command) {
  if (command.forward == target_.forward && command.turn == target_.turn) {
    return;
  }
  target_ = command;
  const int16_t speed = magnitude(command.forward);
  const int16_t turn = magnitude(command.turn);
  is_mostly_turn_ = turn > speed;
  curve_ = is_mostly_turn_ ? byte_share(speed, turn) : byte_share(turn, speed);
}

void Ramps::step(const DriveProfile& profile) {
  if (target_.is_zero()) {  // H-03
    fall_together(forward_.value() < 0 ? profile.reverse_deceleration : profile.forward_deceleration,
                  profile.turn_deceleration);
    return;
  }
  is_falling_ = false;
  if (turn_.value() != target_.turn) {
    approach_turn(profile);
  }
  if (forward_.value() != target_.forward) {
    forward_.approach(target_.forward, profile.acceleration,
                      forward_.value() < 0 ? profile.reverse_deceleration : profile.forward_deceleration);
    const int16_t room = static_cast<int16_t>(full_demand.count() - magnitude(turn_.value()));
    if (magnitude(forward_.value()) > room) {
      forward_.put(limited(forward_.value(), room));
    }
  }
}

void Ramps::approach_turn(const DriveProfile& profile) {
  const int16_t before = turn_.value();
  turn_.approach(target_.turn, profile.turn_acceleration, profile.turn_deceleration);
  const int16_t turn = magnitude(turn_.value());
  const int16_t speed = magnitude(forward_.value());
  if (turn <= magnitude(before) || speed >= magnitude(target_.forward)) {
    return;
  }
  if (is_mostly_turn_ ? scaled(turn, curve_) > speed : turn > scaled(speed, curve_)) {
    turn_.put(before);
  }
}

void Ramps::stop(const DriveProfile& profile) {
  fall_together(profile.emergency_deceleration, profile.emergency_deceleration);
}

void Ramps::fall_together(uint16_t forward_rate, uint16_t turn_rate) {
  const bool is_mostly_turn = magnitude(turn_.value()) > magnitude(forward_.value());
  Ramp& larger = is_mostly_turn ? turn_ : forward_;
  Ramp& smaller = is_mostly_turn ? forward_ : turn_;
  if (larger.value() == 0) {
    return;
  }
  if (!is_falling_) {
    is_falling_ = true;
    const int16_t proportion = proportion_of(magnitude(smaller.value()), magnitude(larger.value()), 14);
    proportion_ = (larger.value() < 0) != (smaller.value() < 0) ? static_cast<int16_t>(-proportion) : proportion;
  }
  const uint16_t rate = is_mostly_turn ? turn_rate : forward_rate;
  const uint16_t other = is_mostly_turn ? forward_rate : turn_rate;
  const bool is_too_fast = times(static_cast<int16_t>(rate), magnitude(proportion_)) > static_cast<int16_t>(other);
  larger.fall(is_too_fast ? other : rate);
  smaller.put(times(larger.value(), proportion_));
}

void Ramps::resume(const Wheels& granted) {
  const int32_t left = granted.left.count();
  const int32_t right = granted.right.count();
  forward_.put(static_cast<int16_t>((left + right) / 2));
  turn_.put(static_cast<int16_t>((left - right) / 2));
  is_falling_ = false;
}

void Ramps::yield_to(const Wheels& granted) {
  const Wheels asked = demand();
  const int32_t left = static_cast<int32_t>(asked.left.count()) - granted.left.count();
  const int32_t right = static_cast<int32_t>(asked.right.count()) - granted.right.count();
  // Half a step may be left over. It is left with the ramps, or a wheel that the gate has stopped at zero on its way to
  // the other side would never get there.
  forward_.put(static_cast<int16_t>(forward_.value() - (left + right) / 2));
  turn_.put(static_cast<int16_t>(turn_.value() - (left - right) / 2));
  is_falling_ = false;
}

}  // namespace spm
