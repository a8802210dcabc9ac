// The SPM's hold on its own supply.
#pragma once

namespace drivers {
namespace power_latch {

void hold();     // SB-1.2: the first output set after reset
void release();  // the supply is gone 250 ms later, unless wake is asserted
void refresh();  // as it was told last (H-27); upkeep.hpp calls it

}  // namespace power_latch
}  // namespace drivers
