// The power module's program compiled for this machine, with the drivers of drivers/host. It runs its loop at the
// moments at which the chip would, takes no time for it, and speaks with the chip's timing.
#pragma once

#include <memory>

#include "simulation/board/spm_board.hpp"

namespace simulation {

// From reset to the start of the chip's clocks, so that its milliseconds and ours fall together; most of it are the
// tests of flash and RAM. tests/image/test_start_up.cpp compares it with the image.
constexpr Time host_start_up = 226'390us;

// Not powered yet, EEPROM erased.
std::unique_ptr<SpmBoard> make_host_board();

}  // namespace simulation
