// The power module's program compiled for this machine, with the drivers of drivers/host. It runs its loop at the
// moments at which the chip would, takes no time for it, and speaks with the chip's timing.
#pragma once

#include <memory>

#include "simulation/board/spm_board.hpp"

namespace simulation {

// Not powered yet, EEPROM erased.
std::unique_ptr<SpmBoard> make_host_board();

}  // namespace simulation
