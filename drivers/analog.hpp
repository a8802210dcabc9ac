// The eight analog inputs, scanned in the background without the loop's help.
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

void start();

// The newest conversion of a channel, 0 to 1023 for 0 to 5 V. Every channel is renewed at least every 2 ms;
// 0 until the first scan is complete.
uint16_t raw(Channel channel);

// True once every channel has been converted at least once since start().
bool is_ready();

}  // namespace analog
}  // namespace drivers
