#include "spm/fault_rules.hpp"

#include "bus/shark/packets.hpp"
#include "drivers/base/flash.hpp"
#include "spm/events.hpp"

namespace spm {

namespace {

using faults::Limps;
using faults::Row;
using faults::Stops;
using State = bus::shark::SystemState;

constexpr Row row(Fault fault, uint16_t debounce_ms, Stops stops, Limps limps, State state, EventCode event) {
  return Row{static_cast<uint8_t>(fault), debounce_ms, stops, limps, static_cast<uint8_t>(state),
             static_cast<uint8_t>(event)};
}

}  // namespace

// clang-format off
extern constexpr Row fault_rows[fault_count] IN_FLASH = {
    //  condition               for ms  stops                    limps                    shows                event
    row(Fault::internal,             0, Stops::until_power_down, Limps::until_power_down, State::power_module, EventCode::internal_fault),
    row(Fault::self_test,            0, Stops::until_power_down, Limps::until_power_down, State::power_module, EventCode::self_test_failed), // H-27
    row(Fault::restart_loop,         0, Stops::until_power_down, Limps::until_power_down, State::power_module, EventCode::restart_loop),     // H-25
    row(Fault::left_motor,           0, Stops::until_power_down, Limps::until_power_down, State::left_motor,   EventCode::left_motor),       // H-10
    row(Fault::right_motor,          0, Stops::until_power_down, Limps::until_power_down, State::right_motor,  EventCode::right_motor),      // H-10
    row(Fault::brake,                0, Stops::until_power_down, Limps::until_power_down, State::left_brake,   EventCode::brake),            // H-13: one sensor, so either
    row(Fault::unexpected_start,     0, Stops::no,               Limps::until_power_down, State::power_module, EventCode::none),             // SB-3.9
    row(Fault::settings_lost,        0, Stops::no,               Limps::until_power_down, State::power_module, EventCode::settings_lost),    // H-20
    row(Fault::corrupt_packets,      0, Stops::until_link,       Limps::until_power_down, State::cable,        EventCode::corrupt_packets),  // SB-2.14
    row(Fault::general_missing,      0, Stops::until_link,       Limps::until_power_down, State::cable,        EventCode::general_missing),  // SB-2.15
    row(Fault::remote_restarted,     0, Stops::until_link,       Limps::until_power_down, State::cable,        EventCode::remote_restarted), // SB-3.4
    row(Fault::joystick_error,       0, Stops::while_present,    Limps::no,               State::remote,       EventCode::joystick_error),   // SB-00.6
    row(Fault::remote_fault,         0, Stops::while_present,    Limps::no,               State::remote,       EventCode::remote_fault),     // SB-00.6
    row(Fault::pot_error,            0, Stops::no,               Limps::until_power_down, State::remote,       EventCode::pot_error),        // SB-00.6
    row(Fault::remote_limps,         0, Stops::no,               Limps::while_present,    State::remote,       EventCode::remote_limps),     // SB-00.6
    row(Fault::battery_flat,      2000, Stops::while_present,    Limps::no,               State::battery,      EventCode::battery_flat),
    row(Fault::battery_low,       1000, Stops::no,               Limps::no,               State::battery,      EventCode::battery_low),      // H-26
    row(Fault::over_voltage,         0, Stops::no,               Limps::no,               State::battery,      EventCode::over_voltage),     // H-26
    row(Fault::stalled,              0, Stops::while_present,    Limps::no,               State::user,         EventCode::stalled),          // H-31
    row(Fault::out_of_neutral,       0, Stops::no,               Limps::no,               State::user,         EventCode::out_of_neutral),   // SB-01.8
};
// clang-format on

namespace {

constexpr bool rows_stand_in_order() {
  for (uint8_t i = 0; i < fault_count; ++i) {
    if (fault_rows[i].fault != i) {
      return false;
    }
  }
  return true;
}
static_assert(rows_stand_in_order(), "row n of the table describes fault n");

}  // namespace

}  // namespace spm
