// Registers that nobody else writes again are written again here: an upset does not last (H-27). What nobody uses stays
// off, and an interrupt that nobody asked for is switched off and forgotten.
#pragma once

namespace drivers {
namespace upkeep {

// Once a millisecond. What motion depends on is written with every second call, the rest, which only could make
// needless interrupts, with every 256th.
void refresh();

}  // namespace upkeep
}  // namespace drivers
