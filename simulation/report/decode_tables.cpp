// The decode tables: one row a packet, one row a field, in the order of the document.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bus/shark/fields.hpp"
#include "simulation/report/decode.hpp"

namespace simulation::report {
namespace {

using bus::shark::Type;

std::vector<FieldRow> sr_general_fields() {
  using namespace bus::shark::sr_general;
  return {
      {"speed", {speed_high, speed_low}, Style::number},
      {"direction", {direction_high, direction_low}, Style::number},
      {"pot", {pot_high, pot_low}, Style::number},
      {"joystick error", {joystick_error}},
      {"pot error", {pot_error}},
      {"local fault", {local_fault}},
      {"charger inhibit", {charger_inhibit}},
      {"power switch", {power_switch}},
      {"horn", {horn}},
      {"lock", {lock}},
      {"hazard request", {hazard_request}},
      {"left request", {left_request}},
      {"right request", {right_request}},
      {"remote inhibit", {remote_inhibit}},
      {"HHP may send", {hhp_may_send}},
      {"calibration active", {calibration_active}},
      {"power-down confirm", {power_down_confirm}},
      {"non-critical fault", {non_critical_fault}},
      {"headlight request", {headlight_request}},
      {"requested mode", {requested_mode}, Style::number},
  };
}

std::vector<FieldRow> spm_general_fields() {
  using namespace bus::shark::spm_general;
  return {
      {"locked", {locked}},
      {"slowdown", {slowdown}},
      {"fuel gauge", {fuel_gauge}, Style::number},
      {"drive inhibited", {drive_inhibited}},
      {"display disabled", {display_disabled}},
      {"power down now", {power_down_now}},
      {"system state", {system_state}, Style::state},
      {"lock mode enabled", {lock_mode_enabled}},
      {"temporary drive modification", {sr_drive_modified}},
      {"joystick wakes", {joystick_wakes}},
      {"sleep requested", {sleep_requested}},
      {"calibration mode", {calibration_mode}},
      {"sound horn", {sound_horn}},
      {"SACU drives", {sacu_drives}},
      {"system driving", {system_driving}},
      {"flash cadence", {flash_cadence}},
      {"hazard light", {hazard_on}},
      {"left light", {left_on}},
      {"right light", {right_on}},
      {"headlight", {headlight_on}},
      {"SACU calibration mode", {sacu_calibration_mode}},
      {"SACU drive modification", {sacu_drive_modified}},
      {"SACU acknowledged", {sacu_acknowledged}},
      {"hazard fault", {hazard_fault}},
      {"left fault", {left_fault}},
      {"right fault", {right_fault}},
      {"headlight fault", {headlight_fault}},
      {"actuator 2 fault", {actuator2_fault}},
      {"actuator 1 fault", {actuator1_fault}},
      {"mode invalid", {sr_mode_invalid}},
      {"mode", {operating_mode}, Style::number},
      {"SACU mode invalid", {sacu_mode_invalid}},
      {"speedo", {speedo}, Style::number},
  };
}

std::vector<FieldRow> sr_power_up_fields() {
  using namespace bus::shark::sr_power_up;
  return {
      {"remote type", {remote_type}, Style::number},
      {"year", {year}, Style::year},
      {"month", {month}, Style::month},
      {"serial", {serial_high, serial_middle, serial_low}, Style::number},
      {"version", {version}, Style::version},
      {"analog pot", {analog_pot}},
      {"actuators", {actuators}},
      {"lighting", {lighting}},
  };
}

std::vector<FieldRow> spm_power_up_fields() {
  using namespace bus::shark::spm_power_up;
  return {{"actuator 2", {actuator2}}, {"actuator 1", {actuator1}}, {"lighting", {lighting}}};
}

std::vector<FieldRow> joystick_calibration_fields() {
  using namespace bus::shark::joystick_calibration;
  return {
      {"second pass", {second_pass}},   {"neutral seen", {neutral_seen}}, {"forward seen", {forward_seen}},
      {"reverse seen", {reverse_seen}}, {"left seen", {left_seen}},       {"right seen", {right_seen}},
  };
}

std::vector<FieldRow> factory_test_fields() {
  using namespace bus::shark::factory_test;
  return {
      {"command", {command}, Style::command},
      {"for the SACU", {is_for_sacu}},
      {"address", {address_high, address_low}, Style::hex},
      {"data", {data_high, data_low}, Style::hex},
  };
}

std::vector<FieldRow> sacu_general_fields() {
  using namespace bus::shark::sacu_general;
  return {
      {"speed", {speed_high, speed_low}, Style::number},
      {"direction", {direction_high, direction_low}, Style::number},
      {"pot", {pot_high, pot_low}, Style::number},
      {"joystick error", {joystick_error}},
      {"pot error", {pot_error}},
      {"local fault", {local_fault}},
      {"calibration active", {calibration_active}},
      {"attendant", {attendant}},
      {"non-critical fault", {non_critical_fault}},
      {"drive inhibit", {drive_inhibit}},
      {"requested mode", {requested_mode}, Style::number},
  };
}

std::vector<FieldRow> sacu_power_up_fields() {
  using namespace bus::shark::sacu_power_up;
  return {
      {"year", {year}, Style::year},
      {"month", {month}, Style::month},
      {"serial", {serial_high, serial_middle, serial_low}, Style::number},
      {"version", {version}, Style::version},
      {"actuator 2", {actuator2}},
      {"actuator 1", {actuator1}},
      {"speed control", {speed_control}},
  };
}

std::vector<FieldRow> spm_settings_fields() {
  using namespace bus::shark::spm_settings;
  return {
      {"speedo option", {speedo_option}},
      {"click on keypress", {click_on_keypress}},
      {"speed button sensitivity", {speed_button_sensitivity}, Style::number},
      {"joystick switch threshold", {joystick_switch_threshold}, Style::number},
  };
}

const std::vector<PacketRow>& packets() {
  static const std::vector<PacketRow> rows{
      {Type::sr_general, "general", 6, sr_general_fields()},
      {Type::spm_general, "general", 7, spm_general_fields()},
      {Type::sr_hhp_data, "HHP data", 1, {}, true},
      {Type::spm_hhp_data, "HHP data", 1, {}, true},
      {Type::sr_power_up, "power-up", 6, sr_power_up_fields()},
      {Type::spm_power_up, "power-up", 1, spm_power_up_fields()},
      {Type::joystick_calibration, "calibration", 1, joystick_calibration_fields()},
      {Type::factory_test, "factory test", 3, factory_test_fields()},
      {Type::sacu_general, "general", 6, sacu_general_fields()},
      {Type::sacu_power_up, "power-up", 7, sacu_power_up_fields()},
      {Type::spm_settings, "settings", 2, spm_settings_fields()},
  };
  return rows;
}

}  // namespace

const PacketRow* find_packet(std::uint8_t type) {
  const auto found = std::find_if(packets().begin(), packets().end(),
                                  [&](const PacketRow& row) { return static_cast<std::uint8_t>(row.type) == type; });
  return found == packets().end() ? nullptr : &*found;
}

const PacketRow& spm_general() {
  return *find_packet(static_cast<std::uint8_t>(Type::spm_general));
}

std::string system_state_name(int state) {
  static const std::array<const char*, system_state_count> names{"System OK",
                                                                 "User fault",
                                                                 "Battery fault",
                                                                 "Left motor fault",
                                                                 "Right motor fault",
                                                                 "Left park brake fault",
                                                                 "Right park brake fault",
                                                                 "Shark remote fault",
                                                                 "Power module fault",
                                                                 "Shark cable fault",
                                                                 "Unknown fault"};
  if (state < 0 || state >= system_state_count) {
    return fmt::format("undefined ({:02X})", state);
  }
  return names[static_cast<std::size_t>(state)];
}

std::string factory_command_name(int command) {
  static const std::array<const char*, 9> names{"read register",  "read RAM",     "read EEPROM",
                                                "write register", "write RAM",    "write EEPROM",
                                                "reset",          "set RAM page", "select device"};
  const auto place = static_cast<std::size_t>(command);
  return place < names.size() ? names[place] : "undefined";
}

}  // namespace simulation::report
