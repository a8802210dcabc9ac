// What a power module thinks. Only the board on the host can tell: there the core is an object of this program. On the
// chip the same members have no names.
#pragma once

#include "spm/fault_rules.hpp"
#include "spm/inhibit.hpp"

namespace simulation {

struct Inside {
  spm::Inhibits inhibits;
  spm::FaultSet faults;  // active: they hold now

  bool operator==(const Inside& other) const { return inhibits == other.inhibits && faults == other.faults; }
};

class InsideView {
 public:
  virtual ~InsideView() = default;
  virtual Inside inside() const = 0;
};

}  // namespace simulation
