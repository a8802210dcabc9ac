#include "spm/drive_gate.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::magnitude;

namespace {

// Magnitudes fit in 15 bits: a demand never exceeds +-16384, and anything that claims to is no demand at all.
constexpr bool is_sane(int16_t value) {
  return value >= -full_demand.count() && value <= full_demand.count();
}
constexpr bool same_side(int16_t value, int16_t other) {
  return (value >= 0) == (other >= 0);
}

// How large the demand may be now, given how large it was.
int16_t ceiling(int16_t last, bool may_rise, bool is_limping) {
  const int16_t fallen =
      static_cast<int16_t>(last > limits::least_fall.count() ? last - limits::least_fall.count() : 0);
  if (!may_rise) {  // SB-2.17, H-01, H-04
    return fallen;
  }
  const int16_t risen = static_cast<int16_t>(last + limits::steepest_rise.count());  // H-33
  const int16_t limp = limits::limp_ceiling.count();
  if (!is_limping || risen <= limp) {
    return risen;
  }
  return last > limp ? (fallen > limp ? fallen : limp) : limp;  // SB-2.16
}

Demand pass_one(Demand wanted, Demand last, bool may_rise, bool is_limping) {
  int16_t value = is_sane(wanted.count()) ? wanted.count() : int16_t{0};
  const int16_t before = last.count();
  const int16_t most = ceiling(magnitude(before), may_rise, is_limping);
  if (before != 0 && !same_side(value, before)) {
    value = 0;
  }
  if (magnitude(value) > most) {
    value = static_cast<int16_t>(value < 0 ? -most : most);
  }
  return Demand(value);
}

}  // namespace

Wheels DriveGate::pass(const Wheels& wanted, const GateFacts& facts) {
  has_refused_ = has_refused_ || !is_sane(wanted.left.count()) || !is_sane(wanted.right.count());
  const bool may_rise = facts.may_drive && facts.general_age <= limits::stale_general;
  Wheels granted;
  if (facts.allows_torque) {  // H-13
    granted.left = pass_one(wanted.left, last_.left, may_rise, facts.is_limping);
    granted.right = pass_one(wanted.right, last_.right, may_rise, facts.is_limping);
  }
  last_ = granted;
  return granted;
}

}  // namespace spm
