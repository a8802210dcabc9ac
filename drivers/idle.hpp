// Sleep between events.
#pragma once

// For the one function that the main loop calls again and again. The AVR's need not save registers for a loop that
// keeps nothing in them; and that nothing lives across turns, neither there nor on the stack, is the point of having it
// (H-27): an upset of what is used anew with each turn is gone with the next. tests/tools/budget looks whether the loop
// is no more than a call.
#ifdef __AVR__
#define TURN_OF_THE_LOOP __attribute__((OS_task, noinline))
#else
#define TURN_OF_THE_LOOP __attribute__((noinline))
#endif

namespace drivers {
namespace idle {

// Sleeps until an interrupt has happened since the last call; returns at once if one has already, so no
// event is slept through.
void wait();

// Lets interrupts in, once every driver has been started.
void enable_interrupts();

}  // namespace idle
}  // namespace drivers
