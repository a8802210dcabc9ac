// Sleep between events.
#pragma once

namespace drivers {
namespace idle {

// Sleeps until an interrupt has happened since the last call; returns at once if one has already, so no
// event is slept through.
void wait();

// Lets interrupts in, once every driver has been started.
void enable_interrupts();

}  // namespace idle
}  // namespace drivers
