// Every bit of every packet of section 5, once: {byte, highest bit, lowest bit} of the data bytes.
// Nothing else in the project names a bit of the wire.
#pragma once

#include "drivers/base/bits.hpp"

namespace bus {
namespace shark {

// Type 00 SR general (SB-00.1, SB-00.2)
namespace sr_general {
constexpr base::Field speed_high{0, 6, 0};
constexpr base::Field direction_high{1, 6, 0};
constexpr base::Field pot_high{2, 6, 0};
constexpr base::Field pot_low{3, 6, 6};
constexpr base::Field speed_low{3, 5, 3};
constexpr base::Field direction_low{3, 2, 0};
constexpr base::Field joystick_error{4, 6, 6};
constexpr base::Field pot_error{4, 5, 5};
constexpr base::Field local_fault{4, 4, 4};
constexpr base::Field charger_inhibit{4, 3, 3};
constexpr base::Field power_switch{4, 2, 2};
constexpr base::Field horn{4, 1, 1};
constexpr base::Field lock{4, 0, 0};
constexpr base::Field hazard_request{5, 6, 6};
constexpr base::Field left_request{5, 5, 5};
constexpr base::Field right_request{5, 4, 4};
constexpr base::Field remote_inhibit{5, 3, 3};
constexpr base::Field hhp_may_send{5, 2, 2};
constexpr base::Field calibration_active{5, 1, 1};
constexpr base::Field power_down_confirm{5, 0, 0};
constexpr base::Field non_critical_fault{6, 5, 5};
constexpr base::Field headlight_request{6, 4, 4};
constexpr base::Field requested_mode{6, 3, 0};
}  // namespace sr_general

// Type 01 SPM general (SB-01.1 to SB-01.7)
namespace spm_general {
constexpr base::Field locked{0, 6, 6};
constexpr base::Field slowdown{0, 5, 5};
constexpr base::Field fuel_gauge{0, 4, 0};
constexpr base::Field drive_inhibited{1, 6, 6};
constexpr base::Field display_disabled{1, 5, 5};
constexpr base::Field power_down_now{1, 4, 4};
constexpr base::Field system_state{1, 3, 0};
constexpr base::Field lock_mode_enabled{2, 6, 6};
constexpr base::Field sr_drive_modified{2, 5, 5};
constexpr base::Field joystick_wakes{2, 4, 4};
constexpr base::Field sleep_requested{2, 3, 3};
constexpr base::Field calibration_mode{2, 2, 2};
constexpr base::Field sound_horn{2, 0, 0};
constexpr base::Field sacu_drives{3, 6, 6};
constexpr base::Field system_driving{3, 5, 5};
constexpr base::Field flash_cadence{3, 4, 4};
constexpr base::Field hazard_on{3, 3, 3};
constexpr base::Field left_on{3, 2, 2};
constexpr base::Field right_on{3, 1, 1};
constexpr base::Field headlight_on{3, 0, 0};
constexpr base::Field sacu_calibration_mode{4, 6, 6};
constexpr base::Field sacu_drive_modified{4, 5, 5};
constexpr base::Field sacu_acknowledged{4, 4, 4};
constexpr base::Field hazard_fault{4, 3, 3};
constexpr base::Field left_fault{4, 2, 2};
constexpr base::Field right_fault{4, 1, 1};
constexpr base::Field headlight_fault{4, 0, 0};
constexpr base::Field actuator2_fault{5, 6, 6};
constexpr base::Field actuator1_fault{5, 5, 5};
constexpr base::Field sr_mode_invalid{5, 4, 4};
constexpr base::Field operating_mode{5, 3, 0};
constexpr base::Field sacu_mode_invalid{6, 5, 5};
constexpr base::Field speedo{6, 4, 0};
}  // namespace spm_general

// Types 02 and 03 HHP data have no fields: each data byte is a character (SB-02.1, SB-03.1).

// Type 04 SR power-up (SB-04.1)
namespace sr_power_up {
constexpr base::Field remote_type{0, 6, 0};
constexpr base::Field year{1, 6, 0};
constexpr base::Field month{2, 3, 0};
constexpr base::Field serial_high{3, 6, 0};
constexpr base::Field serial_middle{4, 6, 0};
constexpr base::Field serial_low{5, 6, 0};
constexpr base::Field version{6, 6, 0};
constexpr base::Field analog_pot{7, 2, 2};
constexpr base::Field actuators{7, 1, 1};
constexpr base::Field lighting{7, 0, 0};
}  // namespace sr_power_up

// Type 05 SPM power-up (SB-05.1)
namespace spm_power_up {
constexpr base::Field actuator2{0, 2, 2};
constexpr base::Field actuator1{0, 1, 1};
constexpr base::Field lighting{0, 0, 0};
}  // namespace spm_power_up

// Type 06 joystick calibration (SB-06.1)
namespace joystick_calibration {
constexpr base::Field second_pass{0, 5, 5};
constexpr base::Field neutral_seen{0, 4, 4};
constexpr base::Field forward_seen{0, 3, 3};
constexpr base::Field reverse_seen{0, 2, 2};
constexpr base::Field left_seen{0, 1, 1};
constexpr base::Field right_seen{0, 0, 0};
}  // namespace joystick_calibration

// Type 07 factory test (SB-07.1)
namespace factory_test {
constexpr base::Field address_high{0, 6, 6};
constexpr base::Field data_high{0, 5, 5};
constexpr base::Field is_for_sacu{0, 4, 4};
constexpr base::Field command{0, 3, 0};
constexpr base::Field address_low{1, 6, 0};
constexpr base::Field data_low{2, 6, 0};
}  // namespace factory_test

// Type 08 SACU general (SB-08.1)
namespace sacu_general {
constexpr base::Field speed_high{0, 6, 0};
constexpr base::Field direction_high{1, 6, 0};
constexpr base::Field pot_high{2, 6, 0};
constexpr base::Field pot_low{3, 6, 6};
constexpr base::Field speed_low{3, 5, 3};
constexpr base::Field direction_low{3, 2, 0};
constexpr base::Field joystick_error{4, 6, 6};
constexpr base::Field pot_error{4, 5, 5};
constexpr base::Field local_fault{4, 4, 4};
constexpr base::Field calibration_active{4, 3, 3};
constexpr base::Field attendant{4, 2, 2};
constexpr base::Field non_critical_fault{4, 1, 1};
constexpr base::Field drive_inhibit{4, 0, 0};
constexpr base::Field requested_mode{5, 3, 0};
}  // namespace sacu_general

// Type 09 SACU power-up (SB-09.1)
namespace sacu_power_up {
constexpr base::Field year{0, 6, 0};
constexpr base::Field month{1, 3, 0};
constexpr base::Field serial_high{2, 6, 0};
constexpr base::Field serial_middle{3, 6, 0};
constexpr base::Field serial_low{4, 6, 0};
constexpr base::Field version{5, 6, 0};
constexpr base::Field actuator2{6, 2, 2};
constexpr base::Field actuator1{6, 1, 1};
constexpr base::Field speed_control{6, 0, 0};
}  // namespace sacu_power_up

// Type 0A SPM programmable settings (SB-0A.2)
namespace spm_settings {
constexpr base::Field speedo_option{0, 5, 5};
constexpr base::Field click_on_keypress{0, 4, 4};
constexpr base::Field speed_button_sensitivity{0, 3, 0};
constexpr base::Field joystick_switch_threshold{1, 6, 0};
}  // namespace spm_settings

}  // namespace shark
}  // namespace bus
