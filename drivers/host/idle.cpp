#include "drivers/idle.hpp"

namespace drivers {
namespace idle {

// The simulation calls the loop when there is something to do.
void wait() {}

void enable_interrupts() {}

}  // namespace idle
}  // namespace drivers
