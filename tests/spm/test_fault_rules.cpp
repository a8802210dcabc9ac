// The table of the power module's faults, held against the catalogue line by line.
#include "spm/fault_rules.hpp"

#include <catch2/catch.hpp>

#include "spm/events.hpp"

namespace {

using namespace spm;
using faults::Limps;
using faults::Stops;

struct Expected {
  Fault fault;
  Stops stops;
  Limps limps;
  int state;
  int debounce;
  EventCode event;
};

const Expected expected[] = {
    {Fault::unexpected_start, Stops::no, Limps::until_power_down, 8, 0, EventCode::none},
    {Fault::left_motor, Stops::until_power_down, Limps::until_power_down, 3, 0, EventCode::left_motor},
    {Fault::right_motor, Stops::until_power_down, Limps::until_power_down, 4, 0, EventCode::right_motor},
    {Fault::brake, Stops::until_power_down, Limps::until_power_down, 5, 0, EventCode::brake},
    {Fault::settings_lost, Stops::no, Limps::until_power_down, 8, 0, EventCode::settings_lost},
    {Fault::corrupt_packets, Stops::until_link, Limps::until_power_down, 9, 0, EventCode::corrupt_packets},
    {Fault::general_missing, Stops::until_link, Limps::until_power_down, 9, 0, EventCode::general_missing},
    {Fault::remote_restarted, Stops::until_link, Limps::until_power_down, 9, 0, EventCode::remote_restarted},
    {Fault::joystick_error, Stops::while_present, Limps::no, 7, 0, EventCode::joystick_error},
    {Fault::remote_fault, Stops::while_present, Limps::no, 7, 0, EventCode::remote_fault},
    {Fault::pot_error, Stops::no, Limps::until_power_down, 7, 0, EventCode::pot_error},
    {Fault::remote_limps, Stops::no, Limps::while_present, 7, 0, EventCode::remote_limps},
    {Fault::battery_flat, Stops::while_present, Limps::no, 2, 2000, EventCode::battery_flat},
    {Fault::out_of_neutral, Stops::no, Limps::no, 1, 0, EventCode::out_of_neutral},
    {Fault::internal, Stops::until_power_down, Limps::until_power_down, 8, 0, EventCode::internal_fault},
    {Fault::self_test, Stops::until_power_down, Limps::until_power_down, 8, 0, EventCode::self_test_failed},
    {Fault::restart_loop, Stops::until_power_down, Limps::until_power_down, 8, 0, EventCode::restart_loop},
    {Fault::battery_low, Stops::no, Limps::no, 2, 1000, EventCode::battery_low},
    {Fault::over_voltage, Stops::no, Limps::no, 2, 0, EventCode::over_voltage},
    {Fault::stalled, Stops::while_present, Limps::no, 1, 0, EventCode::stalled},
};

TEST_CASE("each fault does to the chair, shows and logs what the requirements say",
          "[table][SB-2.14][SB-2.15][SB-2.16][SB-3.4][SB-3.9][SB-00.6][SB-01.9]") {
  unsigned covered = 0;
  for (const Expected& one : expected) {
    const faults::Row row = fault_rows[static_cast<std::uint8_t>(one.fault)];
    CAPTURE(int(one.fault));
    CHECK(row.fault == static_cast<std::uint8_t>(one.fault));
    CHECK(row.stops == one.stops);
    CHECK(row.limps == one.limps);
    CHECK(int(row.system_state) == one.state);
    CHECK(int(row.debounce_ms) == one.debounce);
    CHECK(row.event == static_cast<std::uint8_t>(one.event));
    ++covered;
  }
  CHECK(covered == fault_count);  // a new fault needs a line above
}

TEST_CASE("what the module itself has wrong is shown before the bus, the bus before the remote, the driver last",
          "[SB-01.9]") {
  const auto place = [](Fault fault) { return static_cast<int>(fault); };
  CHECK(place(Fault::internal) < place(Fault::left_motor));
  CHECK(place(Fault::right_motor) < place(Fault::brake));
  CHECK(place(Fault::brake) < place(Fault::corrupt_packets));
  CHECK(place(Fault::corrupt_packets) < place(Fault::joystick_error));
  CHECK(place(Fault::general_missing) < place(Fault::joystick_error));
  CHECK(place(Fault::remote_limps) < place(Fault::battery_flat));
  CHECK(place(Fault::battery_flat) < place(Fault::out_of_neutral));
}

}  // namespace
