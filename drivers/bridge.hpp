// Everything that can move the chair: two motor bridges, the contactor of their supply, two park brakes.
// A default-constructed Motion is the safe state: bridges and contactor off, duty 0 (motors shorted
// by the bridge's pull-downs), brakes engaged by their springs.
#pragma once

#include <stdint.h>

namespace drivers {
namespace bridge {

// Full duty; 9-bit PWM at 15.6 kHz.
constexpr uint16_t full_duty = 511;

struct Wheel {
  uint16_t duty = 0;  // 0 to full_duty
  bool is_forward = true;
};

struct Motion {
  Wheel left;
  Wheel right;
  bool bridge_enabled = false;
  bool relay_closed = false;
  bool left_brake_released = false;
  bool right_brake_released = false;
};

// Safe state onto the pins, PWM running at duty 0.
void start();

// Writes every register that motion depends on, configuration included. Values above full_duty become 0.
void apply(const Motion& motion);

}  // namespace bridge
}  // namespace drivers
