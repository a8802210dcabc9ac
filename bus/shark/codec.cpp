#include "bus/shark/codec.hpp"

#include "bus/shark/fields.hpp"
#include "bus/shark/packet_table.hpp"
#include "drivers/base/bits.hpp"
#include "drivers/base/flash.hpp"

namespace bus {
namespace shark {

namespace {

__attribute__((always_inline)) inline JoystickReading reading(const uint8_t* data, base::Field high, base::Field low) {
  return JoystickReading(static_cast<uint16_t>(base::read(data, high) * 8U + base::read(data, low)));
}

__attribute__((always_inline)) inline PotReading pot_reading(const uint8_t* data, base::Field high, base::Field low) {
  return PotReading(static_cast<uint8_t>(base::read(data, high) * 2U + base::read(data, low)));
}

// Two parts of a byte that bit 7's marker leaves no room for: its highest bit, and the rest.
__attribute__((always_inline)) inline uint8_t whole_byte(const uint8_t* data, base::Field high, base::Field low) {
  return static_cast<uint8_t>((base::read(data, high) << 7) | base::read(data, low));
}

__attribute__((always_inline)) inline uint32_t serial_number(const uint8_t* data, base::Field high, base::Field middle,
                                                             base::Field low) {
  return (static_cast<uint32_t>(base::read(data, high)) << 14) |
         (static_cast<uint16_t>(base::read(data, middle)) << 7) | base::read(data, low);
}

__attribute__((always_inline)) inline Frame empty_frame(Type type) {
  Frame frame;
  frame.type = static_cast<uint8_t>(type);
  frame.length = data_said(type);
  return frame;
}

}  // namespace

Admission admit(const Frame& frame) {
  const uint8_t least = base::flash_byte(&packet_table[frame.type % type_count].least_heard);  // SB-5.3
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
  packet.pot = pot_reading(data, at::pot_high, at::pot_low);
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
  packet.serial = serial_number(data, at::serial_high, at::serial_middle, at::serial_low);
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

HhpData decode_sr_hhp_data(const Frame& frame) {
  HhpData packet;
  packet.characters = frame.data;
  packet.count = frame.length;
  return packet;
}

JoystickCalibration decode_joystick_calibration(const Frame& frame) {  // SB-06.1
  namespace at = joystick_calibration;
  const uint8_t* data = frame.data.items;
  JoystickCalibration packet;
  packet.second_pass = base::is_set(data, at::second_pass);
  packet.neutral_seen = base::is_set(data, at::neutral_seen);
  packet.forward_seen = base::is_set(data, at::forward_seen);
  packet.reverse_seen = base::is_set(data, at::reverse_seen);
  packet.left_seen = base::is_set(data, at::left_seen);
  packet.right_seen = base::is_set(data, at::right_seen);
  return packet;
}

FactoryTest decode_factory_test(const Frame& frame) {  // SB-07.1
  namespace at = factory_test;
  const uint8_t* data = frame.data.items;
  FactoryTest packet;
  packet.is_for_sacu = base::is_set(data, at::is_for_sacu);
  packet.command = base::read(data, at::command);
  packet.address = whole_byte(data, at::address_high, at::address_low);
  packet.data = whole_byte(data, at::data_high, at::data_low);
  return packet;
}

SacuGeneral decode_sacu_general(const Frame& frame) {  // SB-08.1
  namespace at = sacu_general;
  const uint8_t* data = frame.data.items;
  SacuGeneral packet;
  packet.speed = reading(data, at::speed_high, at::speed_low);
  packet.direction = reading(data, at::direction_high, at::direction_low);
  packet.pot = pot_reading(data, at::pot_high, at::pot_low);
  packet.joystick_error = base::is_set(data, at::joystick_error);
  packet.pot_error = base::is_set(data, at::pot_error);
  packet.local_fault = base::is_set(data, at::local_fault);
  packet.calibration_active = base::is_set(data, at::calibration_active);
  packet.attendant = base::is_set(data, at::attendant);
  packet.non_critical_fault = base::is_set(data, at::non_critical_fault);
  packet.drive_inhibit = base::is_set(data, at::drive_inhibit);
  packet.requested_mode = base::read(data, at::requested_mode);
  return packet;
}

SacuPowerUp decode_sacu_power_up(const Frame& frame) {  // SB-09.1
  namespace at = sacu_power_up;
  const uint8_t* data = frame.data.items;
  SacuPowerUp packet;
  packet.year = base::read(data, at::year);
  packet.month = base::read(data, at::month);
  packet.serial = serial_number(data, at::serial_high, at::serial_middle, at::serial_low);
  packet.version = base::read(data, at::version);
  packet.supports_actuator2 = base::is_set(data, at::actuator2);
  packet.supports_actuator1 = base::is_set(data, at::actuator1);
  packet.has_speed_control = base::is_set(data, at::speed_control);
  return packet;
}

Frame encode(const SpmGeneral& packet) {
  namespace at = spm_general;
  Frame frame = empty_frame(Type::spm_general);
  uint8_t* data = frame.data.items;
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
  return frame;
}

Frame encode(const HhpData& packet) {
  Frame frame = empty_frame(Type::spm_hhp_data);
  frame.length = packet.count;
  frame.data = packet.characters;
  return frame;
}

Frame encode(const SpmPowerUp& packet) {
  namespace at = spm_power_up;
  Frame frame = empty_frame(Type::spm_power_up);
  uint8_t* data = frame.data.items;
  base::put(data, at::actuator2, packet.supports_actuator2);
  base::put(data, at::actuator1, packet.supports_actuator1);
  base::put(data, at::lighting, packet.supports_lighting);
  return frame;
}

Frame encode(const SpmSettings& packet) {
  namespace at = spm_settings;
  Frame frame = empty_frame(Type::spm_settings);
  uint8_t* data = frame.data.items;
  base::put(data, at::speedo_option, packet.speedo_option);
  base::put(data, at::click_on_keypress, packet.click_on_keypress);
  base::put(data, at::speed_button_sensitivity, packet.speed_button_sensitivity);
  base::put(data, at::joystick_switch_threshold, packet.joystick_switch_threshold);
  return frame;
}

}  // namespace shark
}  // namespace bus
