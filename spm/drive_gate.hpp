// The last gate before the motors. It trusts nobody: not the ramps, not the settings, not the inhibits' authors.
// Whatever it is handed, what comes out keeps these rules, each millisecond:
//
//   1. Without leave to drive, or without a fresh general, no wheel's demand grows, and the larger one falls fast
//      enough to be zero in time; the other is never larger, so that a stop may keep its curve.
//   2. No torque against an engaged brake.
//   3. The demand never rises faster than the hard limit and never changes sign without passing zero.
//   4. Limping, it never exceeds the hard ceiling, and falls to it if it was above.
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
  // It was once handed a demand beyond full motor voltage: whoever made it is broken.
  bool has_refused() const { return has_refused_; }

 private:
  Demand checked(Demand wanted);

  Wheels last_;
  bool has_refused_ = false;
};

}  // namespace spm
