#include "bus/shark/codec.hpp"

#include "bus/shark/fields.hpp"
#include "drivers/base/bits.hpp"
#include "drivers/base/flash.hpp"

namespace bus {
namespace shark {

namespace {

using Data = base::Span<const uint8_t>;

// SB-5.3: the least data of each type that is sent to us; 0 = not for us, or reserved (SB-5.1).
const uint8_t least_data[16] IN_FLASH = {6, 0, 1, 0, 6, 0, 1, 3, 6, 7, 0, 0, 0, 0, 0, 0};

__attribute__((always_inline)) inline JoystickReading reading(const uint8_t* data, base::Field high, base::Field low) {
  return JoystickReading(static_cast<uint16_t>(base::read(data, high) * 8U + base::read(data, low)));
}

}  // namespace

Admission admit(const Frame& frame) {
  const uint8_t least = base::flash_byte(&least_data[frame.type & 0x0F]);
  if (least == 0) {
    return Admission::unknown;
  }
  return frame.length < least ? Admission::corrupt : Admission::known;
}

SrGeneral decode_sr_general(const Frame& frame) {
  namespace at = sr_general;
  const uint8_t* data = frame.data.items;
  SrGeneral packet;
  packet.speed = reading(data, at::speed_high, at::speed_low);              // SB-00.1
  packet.direction = reading(data, at::direction_high, at::direction_low);  // SB-00.1
  packet.pot = PotReading(static_cast<uint8_t>(base::read(data, at::pot_high) * 2U + base::read(data, at::pot_low)));
  packet.joystick_error = base::is_set(data, at::joystick_error);
  packet.pot_error = base::is_set(data, at::pot_error);
  packet.local_fault = base::is_set(data, at::local_fault);
  packet.charger_inhibit = base::is_set(data, at::charger_inhibit);
  packet.power_switch = base::is_set(data, at::power_switch);
  packet.horn = base::is_set(data, at::horn);
  packet.lock = base::is_set(data, at::lock);
  packet.hazard_request = base::is_set(data, at::hazard_request);
  packet.left_request = base::is_set(data, at::left_request);
  packet.right_request = base::is_set(data, at::right_request);
  packet.remote_inhibit = base::is_set(data, at::remote_inhibit);
  packet.hhp_may_send = base::is_set(data, at::hhp_may_send);
  packet.calibration_active = base::is_set(data, at::calibration_active);
  packet.power_down_confirm = base::is_set(data, at::power_down_confirm);
  packet.has_modes = frame.length > at::requested_mode.byte;
  if (packet.has_modes) {  // SB-00.3: an old remote sends no byte 6
    packet.non_critical_fault = base::is_set(data, at::non_critical_fault);
    packet.headlight_request = base::is_set(data, at::headlight_request);
    packet.requested_mode = base::read(data, at::requested_mode);
  }
  return packet;
}

SrPowerUp decode_sr_power_up(const Frame& frame) {
  namespace at = sr_power_up;
  const uint8_t* data = frame.data.items;
  SrPowerUp packet;
  packet.remote_type = base::read(data, at::remote_type);
  packet.year = base::read(data, at::year);
  packet.month = base::read(data, at::month);
  packet.serial = (static_cast<uint32_t>(base::read(data, at::serial_high)) << 14) |
                  (static_cast<uint16_t>(base::read(data, at::serial_middle)) << 7) | base::read(data, at::serial_low);
  packet.version = frame.length > at::version.byte ? base::read(data, at::version) : uint8_t{0};
  if (frame.length > at::lighting.byte) {  // SB-04.2
    packet.supports_actuators = base::is_set(data, at::actuators);
    packet.supports_lighting = base::is_set(data, at::lighting);
    constexpr uint8_t pre_release = 0x08;
    constexpr uint8_t version_2_5 = 0x25;
    const bool honours_pot = (packet.version & ~pre_release) >= version_2_5;
    packet.has_analog_pot = honours_pot && base::is_set(data, at::analog_pot);  // SB-04.2
  }
  return packet;
}

Packet::Packet(Type type, base::Span<const uint8_t> data) : bytes_(), size_(static_cast<uint8_t>(data.size() + 2)) {
  uint8_t* to = bytes_.items;
  uint8_t sum = start_byte(type, data.size());
  *to++ = sum;
  for (const uint8_t byte : data) {
    const uint8_t marked = static_cast<uint8_t>(byte | marker_bit);  // SB-2.4
    *to++ = marked;
    sum = static_cast<uint8_t>(sum + marked);
  }
  *to = checksum(sum);  // SB-2.5
}

Packet encode(const SpmGeneral& packet) {
  namespace at = spm_general;
  uint8_t data[7] = {};
  base::put(data, at::locked, packet.locked);
  base::put(data, at::slowdown, packet.slowdown);
  base::put(data, at::fuel_gauge, packet.fuel_gauge);
  base::put(data, at::drive_inhibited, packet.drive_inhibited);
  base::put(data, at::display_disabled, packet.display_disabled);
  base::put(data, at::power_down_now, packet.power_down_now);
  base::put(data, at::system_state, static_cast<uint8_t>(packet.system_state));
  base::put(data, at::lock_mode_enabled, packet.lock_mode_enabled);
  base::put(data, at::sr_drive_modified, packet.sr_drive_modified);
  base::put(data, at::joystick_wakes, packet.joystick_wakes);
  base::put(data, at::sleep_requested, packet.sleep_requested);
  base::put(data, at::calibration_mode, packet.calibration_mode);
  base::put(data, at::sound_horn, packet.sound_horn);
  base::put(data, at::sacu_drives, packet.sacu_drives);
  base::put(data, at::system_driving, packet.system_driving);
  base::put(data, at::flash_cadence, packet.flash_cadence);
  base::put(data, at::hazard_on, packet.hazard_on);
  base::put(data, at::left_on, packet.left_on);
  base::put(data, at::right_on, packet.right_on);
  base::put(data, at::headlight_on, packet.headlight_on);
  base::put(data, at::sacu_calibration_mode, packet.sacu_calibration_mode);
  base::put(data, at::sacu_drive_modified, packet.sacu_drive_modified);
  base::put(data, at::sacu_acknowledged, packet.sacu_acknowledged);
  base::put(data, at::hazard_fault, packet.hazard_fault);
  base::put(data, at::left_fault, packet.left_fault);
  base::put(data, at::right_fault, packet.right_fault);
  base::put(data, at::headlight_fault, packet.headlight_fault);
  base::put(data, at::actuator2_fault, packet.actuator2_fault);
  base::put(data, at::actuator1_fault, packet.actuator1_fault);
  base::put(data, at::sr_mode_invalid, packet.sr_mode_invalid);
  base::put(data, at::operating_mode, packet.operating_mode);
  base::put(data, at::sacu_mode_invalid, packet.sacu_mode_invalid);
  base::put(data, at::speedo, packet.speedo);
  return Packet(Type::spm_general, Data(data, sizeof data));
}

Packet encode(const SpmPowerUp& packet) {
  namespace at = spm_power_up;
  uint8_t data[1] = {};
  base::put(data, at::actuator2, packet.supports_actuator2);
  base::put(data, at::actuator1, packet.supports_actuator1);
  base::put(data, at::lighting, packet.supports_lighting);
  return Packet(Type::spm_power_up, Data(data, sizeof data));
}

Packet encode(const SpmSettings& packet) {
  namespace at = spm_settings;
  uint8_t data[2] = {};
  base::put(data, at::speedo_option, packet.speedo_option);
  base::put(data, at::click_on_keypress, packet.click_on_keypress);
  base::put(data, at::speed_button_sensitivity, packet.speed_button_sensitivity);
  base::put(data, at::joystick_switch_threshold, packet.joystick_switch_threshold);
  return Packet(Type::spm_settings, Data(data, sizeof data));
}

}  // namespace shark
}  // namespace bus
