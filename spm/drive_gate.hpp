// The last gate before the motors. It trusts nobody: not the ramps, not the settings, not the inhibits' authors.
// Whatever it is handed, what comes out keeps these rules, each millisecond:
//
//   1. Without leave to drive, or without a fresh general, no wheel's demand grows, and the larger one falls fast
//      enough to be zero in time; the other is never larger, so that a stop may keep its curve.
//   2. No torque against an engaged brake.
//   3. The demand never rises faster than the hard limit and never changes sign without passing zero.
//   4. Limping, it never exceeds the hard ceiling, and falls to it if it was above.
//   5. Once it was handed a demand beyond full voltage, nobody has leave any more.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"
#include "spm/drive.hpp"

namespace spm {

struct GateFacts {
  bool may_drive = false;      // no inhibit of any kind
  bool allows_torque = false;  // brakes fully released
  bool is_limping = true;
  base::Millis general_age = base::Millis(UINT32_MAX);  // since the last valid general of the driver
};

class DriveGate {
 public:
  Wheels pass(const Wheels& wanted, const GateFacts& facts);
  // Whether the last demand was allowed to rise.
  bool has_leave() const { return has_leave_; }
  // What it let through last.
  const Wheels& last() const { return last_; }
  // The same, where memory has forgotten it.
  void remember(const Wheels& last) { last_ = last; }
  // It was once handed a demand beyond full motor voltage: whoever made it is broken.
  bool has_refused() const { return has_refused_; }

 private:
  Demand checked(Demand wanted, Demand last);

  Wheels last_;
  bool has_leave_ = false;
  bool has_refused_ = false;
};

}  // namespace spm
