// The eight analog inputs. One conversion goes on while the loop does something else; there is no interrupt for it.
#pragma once

#include <stdint.h>

namespace drivers {
namespace analog {

enum class Channel : uint8_t {
  battery,        // 8:1 divider, 0-40 V
  left_current,   // 2.5 V = 0 A, 20 mV per ampere, forward positive
  right_current,  // as left
  brake_coils,    // both coils, 1 V per ampere
  left_lamp,      // 1 V per ampere
  right_lamp,     // 1 V per ampere
  headlight,      // 1 V per ampere
  actuators,      // 0.2 V per ampere
};
constexpr uint8_t channel_count = 8;
constexpr uint8_t quick_channels = 4;  // the first four: what driving depends on

void start();

// Once a millisecond: takes what has been converted and begins the next conversion. Five calls renew the quick channels
// and one of the others; each of the others is renewed every 20. Does nothing if called within 0.21 ms of the last time.
void scan();

// The newest conversion of a channel, 0 to 1023 for 0 to 5 V; 0 until there is one. As long as nobody else calls scan(),
// whoever reads a quick channel with every fifth call sees no conversion twice.
uint16_t raw(Channel channel);

// True once every channel has been converted at least once since start().
bool is_ready();

}  // namespace analog
}  // namespace drivers
