// The Shark Remote (SR): wakes the SPM, sends its power-up packet until answered, then its general every
// 20 ms, and confirms power-down. It codes and decodes the wire by itself, on purpose: an oracle that shared
// the firmware's codec would share its mistakes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulation/time.hpp"

namespace simulation {

// What the person at the joystick does, and what the remote reports about itself.
struct RemoteControls {
  int speed = 512;  // raw reading 0 to 1023
  int direction = 512;
  int pot = 255;  // 0 to 255
  bool power_button = false;
  bool horn = false;
  bool lock = false;
  bool hazard = false;
  bool left_indicator = false;
  bool right_indicator = false;
  bool headlight = false;
  bool joystick_error = false;
  bool pot_error = false;
  bool local_fault = false;
  bool non_critical_fault = false;
  bool charger_inhibit = false;
  bool remote_inhibit = false;
  bool calibration_active = false;
  bool hhp_may_send = true;
  int mode = 0;  // requested operating mode
};

struct RemoteIdentity {
  int type = 2;
  int year = 2006;
  int month = 11;
  int serial = 4810;
  int version = 0x25;
  int capabilities = 0x03;
  int power_up_length = 8;  // 6, 7 or 8 data bytes
  int general_length = 7;   // 6 = old remote
};

// What the remote has understood from the SPM's last valid general packet.
struct SpmReport {
  std::array<std::uint8_t, 7> data{};  // marker bits stripped
  Time at{};
};

}  // namespace simulation
