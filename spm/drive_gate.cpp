#include "spm/drive_gate.hpp"

#include "spm/limits.hpp"

namespace spm {

using base::magnitude;

namespace {

constexpr int16_t smaller(int16_t value, int16_t other) {
  return value < other ? value : other;
}
constexpr int16_t fallen_from(int16_t last) {
  return static_cast<int16_t>(last > limits::least_fall.count() ? last - limits::least_fall.count() : 0);
}

// How large a wheel's demand may be now, given how large it was.
int16_t driving_ceiling(int16_t last, bool is_limping) {
  const int16_t risen = static_cast<int16_t>(last + limits::steepest_rise.count());  // H-33
  const int16_t limp = limits::limp_ceiling.count();
  if (!is_limping || risen <= limp) {
    return risen;
  }
  const int16_t fallen = fallen_from(last);
  return fallen > limp ? fallen : limp;  // SB-2.16
}

// Nearer to zero than `most`, and not beyond zero.
Demand bounded(Demand wanted, Demand last, int16_t most) {
  const int16_t high = last < Demand(0) ? int16_t{0} : most;
  const int16_t low = last > Demand(0) ? int16_t{0} : static_cast<int16_t>(-most);
  return Demand(wanted.count() > high ? high : wanted.count() < low ? low : wanted.count());
}

}  // namespace

Wheels DriveGate::pass(const Wheels& wanted, const GateFacts& facts) {
  const Wheels sane{checked(wanted.left, last_.left), checked(wanted.right, last_.right)};
  has_leave_ = facts.may_drive && !has_refused_ && facts.general_age <= limits::stale_general;
  if (!facts.allows_torque) {  // H-13
    last_ = Wheels();
    return last_;
  }
  const int16_t left = magnitude(last_.left.count());
  const int16_t right = magnitude(last_.right.count());
  if (has_leave_) {
    last_.left = bounded(sane.left, last_.left, driving_ceiling(left, facts.is_limping));
    last_.right = bounded(sane.right, last_.right, driving_ceiling(right, facts.is_limping));
  } else {  // SB-2.17, H-01, H-04
    const int16_t fallen = fallen_from(left > right ? left : right);
    last_.left = bounded(sane.left, last_.left, smaller(left, fallen));
    last_.right = bounded(sane.right, last_.right, smaller(right, fallen));
  }
  return last_;
}

// A demand that claims to exceed full voltage is none at all: from what there was before, the wheel falls.
Demand DriveGate::checked(Demand wanted, Demand last) {
  if (wanted >= -full_demand && wanted <= full_demand) {
    return wanted;
  }
  has_refused_ = true;
  return last;
}

}  // namespace spm
