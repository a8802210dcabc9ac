// One plain struct for each packet the power module hears or says, in wire order, with the document's names.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "drivers/base/span.hpp"
#include "drivers/base/units.hpp"

namespace bus {
namespace shark {

// A joystick axis as sent: 0 to 1023, 512 = neutral, larger = forward or right (SB-00.8).
using JoystickReading = base::Quantity<struct JoystickReadingTag, uint16_t>;
constexpr JoystickReading joystick_neutral = JoystickReading(512);
// The speed pot as sent: 0 = slowest, 255 = fastest.
using PotReading = base::Quantity<struct PotReadingTag, uint8_t>;

// Operating modes (byte 6 of type 00, byte 5 of type 01); 4 to 15 are undefined and always invalid.
namespace mode {
constexpr uint8_t drive = 0;
constexpr uint8_t actuator1 = 1;
constexpr uint8_t actuator2 = 2;
constexpr uint8_t both_actuators = 3;
}  // namespace mode

// Type 00, from the remote, every 20 ms.
struct SrGeneral {
  JoystickReading speed = joystick_neutral;
  JoystickReading direction = joystick_neutral;
  PotReading pot;
  bool joystick_error = false;
  bool pot_error = false;
  bool local_fault = false;
  bool charger_inhibit = false;
  bool power_switch = false;
  bool horn = false;
  bool lock = false;
  bool hazard_request = false;
  bool left_request = false;
  bool right_request = false;
  bool remote_inhibit = false;
  bool hhp_may_send = false;
  bool calibration_active = false;
  bool power_down_confirm = false;
  // Byte 6, absent from an old remote's 6 data bytes (SB-00.3); then false and 0.
  bool has_modes = false;
  bool non_critical_fault = false;
  bool headlight_request = false;
  uint8_t requested_mode = mode::drive;
};

// What system state (byte 1 of type 01) can say; also the count of flashes.
enum class SystemState : uint8_t {
  ok = 0x0,
  user = 0x1,
  battery = 0x2,
  left_motor = 0x3,
  right_motor = 0x4,
  left_brake = 0x5,
  right_brake = 0x6,
  remote = 0x7,
  power_module = 0x8,
  cable = 0x9,
  unknown = 0xA,
};

// Type 01, ours, first in every answer.
struct SpmGeneral {
  bool locked = false;
  bool slowdown = false;
  uint8_t fuel_gauge = 0;  // 0 to 18
  bool drive_inhibited = false;
  bool display_disabled = false;
  bool power_down_now = false;
  SystemState system_state = SystemState::ok;
  bool lock_mode_enabled = false;
  bool sr_drive_modified = false;
  bool joystick_wakes = false;
  bool sleep_requested = false;
  bool calibration_mode = false;
  bool sound_horn = false;
  bool sacu_drives = false;
  bool system_driving = false;
  bool flash_cadence = false;
  bool hazard_on = false;
  bool left_on = false;
  bool right_on = false;
  bool headlight_on = false;
  bool sacu_calibration_mode = false;
  bool sacu_drive_modified = false;
  bool sacu_acknowledged = false;
  bool hazard_fault = false;
  bool left_fault = false;
  bool right_fault = false;
  bool headlight_fault = false;
  bool actuator2_fault = false;
  bool actuator1_fault = false;
  bool sr_mode_invalid = false;
  uint8_t operating_mode = mode::drive;
  bool sacu_mode_invalid = false;
  uint8_t speedo = 0;  // 0 to 31
};

// Types 02 and 03: characters from and to the programmer behind the remote, 7 bits each.
struct HhpData {
  base::Array<uint8_t, longest_data> characters = {};
  uint8_t count = 0;  // 1 to 8
};

// Type 04, from the remote until answered.
struct SrPowerUp {
  uint8_t remote_type = 0;
  uint8_t year = 0;   // less 2000
  uint8_t month = 0;  // 1 to 12
  uint32_t serial = 0;
  uint8_t version = 0;  // SB-04.3; 0 if absent
  bool has_analog_pot = false;
  bool supports_actuators = false;
  bool supports_lighting = false;
};

// Type 05, our answer to type 04.
struct SpmPowerUp {
  bool supports_actuator2 = false;
  bool supports_actuator1 = false;
  bool supports_lighting = false;
};

// Type 06, from the remote or the attendant control while its joystick is calibrated: what it has seen so far.
struct JoystickCalibration {
  bool second_pass = false;
  bool neutral_seen = false;  // at the end
  bool forward_seen = false;
  bool reverse_seen = false;
  bool left_seen = false;
  bool right_seen = false;
};

// Type 07, from a test fixture to the remote or the attendant control; never for us.
struct FactoryTest {
  bool is_for_sacu = false;
  uint8_t command = 0;  // 0 to 15
  uint8_t address = 0;
  uint8_t data = 0;
};

// Type 08, from the attendant control, after our turn.
struct SacuGeneral {
  JoystickReading speed = joystick_neutral;
  JoystickReading direction = joystick_neutral;
  PotReading pot;  // 0 from one without speed control (SB-08.3)
  bool joystick_error = false;
  bool pot_error = false;
  bool local_fault = false;
  bool calibration_active = false;
  bool attendant = false;  // the switch: the attendant is to drive
  bool non_critical_fault = false;
  bool drive_inhibit = false;
  uint8_t requested_mode = mode::drive;
};

// Type 09, from the attendant control until acknowledged.
struct SacuPowerUp {
  uint8_t year = 0;   // less 2000
  uint8_t month = 0;  // 1 to 12
  uint32_t serial = 0;
  uint8_t version = 0;  // as SB-04.3
  bool supports_actuator2 = false;
  bool supports_actuator1 = false;
  bool has_speed_control = false;
};

// Type 0A, ours, at least once a second.
struct SpmSettings {
  bool speedo_option = false;
  bool click_on_keypress = false;
  uint8_t speed_button_sensitivity = 5;    // 1 to 10
  uint8_t joystick_switch_threshold = 39;  // 1 to 100
};

}  // namespace shark
}  // namespace bus
