// The Shark Bus transceiver: UART0, 38400 bps 8N2, half duplex (SB-2.1). The transmit pin is recessive
// (high) except while a turn is being sent (SB-1.1). Our own characters come back from the line; they are
// checked here and never handed out (SB-1.4).
#pragma once

#include <stdint.h>

#include "drivers/base/heard_byte.hpp"
#include "drivers/base/span.hpp"
#include "drivers/base/turn_sender.hpp"

namespace drivers {
namespace serial {

// Configures the UART and begins to listen. Call once, interrupts still off.
void start();

// The loop is woken by every character, but not before `count` more than it has taken have come: until then nobody
// needs it. Whoever wants to know earlier is woken by the clock.
void expect(uint8_t count);

// Wakes the loop 3 ms after the end of a character that nothing has followed (SB-2.11).

// The oldest character that was heard and not yet taken; false if there is none. Characters lost because
// nobody took them mark the next one as spoiled.
bool take(base::HeardByte& byte);

// Speaks `turn` as soon as a clean `terminator` has ended on the line: the first start bit follows the
// terminator's last stop bit by less than 100 us, whatever the loop is doing; if the terminator has been heard less
// than 1 ms ago and nothing since, at once. The bytes are copied. Replaces a turn that still waits; ignored while
// speaking.
void arm(uint8_t terminator, base::Span<const uint8_t> turn);

// Speaks `turn` now, or not at all if already speaking. For the rare cases without a terminator (SB-2.12).
void speak(base::Span<const uint8_t> turn);

// Forgets a waiting turn and the rest of one being sent.
void hush();

// The transmitter does not come to an end: it is off until the next refresh(), and nothing is left to say (H-30).
void cut();

base::TurnSender::State state();

// Whether an echo differed from what was sent since this was last asked (SB-1.4).
bool take_clash();

// Nothing that was heard waits to be taken, neither here nor in the receiver (H-25).
bool is_all_taken();

// Writes the UART's configuration registers again, undoing an upset (H-27); upkeep.hpp calls it.
void refresh();

}  // namespace serial
}  // namespace drivers
