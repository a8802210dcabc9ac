// What the event log can say. Numbers are stable: logs outlive firmware versions.
#pragma once

#include <stdint.h>

namespace spm {

enum class EventCode : uint8_t {
  none = 0,
  started = 1,             // SB-3.9; argument: 0 power on, 1 watchdog, 2 brown-out, 3 external reset
  echo_differed = 2,       // SB-1.4
  factory_test_heard = 3,  // SB-07.1; argument: command
  remote_restarted = 4,    // SB-3.4
  power_down_asked = 5,    // argument: 0 button, 1 sleep
  powered_down = 6,        // argument: 0 confirmed; 1 remote gone, in memory only: the supply does not wait for it
  answer_too_late = 7,     // a turn was earned but the slot had passed
  time_was_lost = 8,       // the loop stood still; argument: milliseconds, at most 255
  hhp_data_lost = 9,       // SB-02.1: more came than was taken; argument: characters, those that were lost first
  corrupt_packets = 16,    // faults from here on: SB-2.14
  general_missing = 17,    // SB-2.15
  joystick_error = 18,     // SB-00.6
  remote_fault = 19,       // SB-00.6
  pot_error = 20,          // SB-00.6
  remote_limps = 21,       // SB-00.6
  out_of_neutral = 22,     // SB-01.8
  battery_flat = 23,
  internal_fault = 24,
  settings_lost = 25,      // H-20
  settings_copy_bad = 26,  // H-20: one of two; the other is used
  left_motor = 30,         // H-10
  right_motor = 31,        // H-10
  brake = 32,              // H-13: either of them, the sensor is one
  self_test_failed = 33,   // H-27; argument: 1 flash at start, 2 RAM at start, 3 flash later
  restart_loop = 34,       // H-25
  battery_low = 35,        // H-26
  over_voltage = 36,       // H-26
  stalled = 37,            // H-31
  clock_differs = 38,      // H-24: milliseconds and microseconds do not agree
  upset_found = 39,        // H-27: a value and its complement do not agree; argument: 1 a permission, 2 the faults,
                           // 3 motion, 4 what was made of the settings, 5 the settings
  transmitter_hung = 40,   // H-30
  stack_overrun = 41,      // H-22
};

}  // namespace spm
