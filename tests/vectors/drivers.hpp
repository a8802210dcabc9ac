// What the board's group needs of the drivers: to say what they measure, and to see what the motors are told.
#pragma once

#include "drivers/bridge.hpp"

namespace vectors {

// All analog channels at once.
void measure(uint16_t raw);
const drivers::bridge::Motion& motion();

}  // namespace vectors
