// The fixed numbers of the power module, each with its clause. What a user may change is in settings.hpp.
#pragma once

#include <stdint.h>

#include "bus/shark/packets.hpp"
#include "bus/shark/turn.hpp"
#include "drivers/base/time.hpp"
#include "drivers/base/turn_sender.hpp"
#include "drivers/base/units.hpp"
#include "faults/link_supervisor.hpp"
#include "spm/outputs.hpp"

namespace spm {
namespace limits {

using namespace base;  // literals

constexpr Millis cycle = 20_ms;  // SB-2.2
// Between two looks at configuration that no longer changes, in house-keepings (H-27).
constexpr uint8_t configuration_check = 4;
constexpr Millis house_keeping = 10_ms;  // between two looks at what changes slowly: battery, supply, gauge, LED
// Of the first one, counted back from the start: it is due 10 ms later, and the raster lies between that of remotes
// which begin to speak at a multiple of 10 ms after wake.
constexpr Millis first_house_keeping = 0_ms;

// Link supervision
constexpr faults::LinkSupervisor::Limits link{
    3,         // SB-2.14: corrupt packets in a row
    61250_us,  // SB-2.15: with the 500 us grain of a step this trips 61.25 to 61.8 ms after the last general
    5,         // SB-2.16: generals in a row that re-establish communication
};
// SB-2.8: later than this the slot belongs to somebody else.
constexpr Micros latest_after_finish = 1500_us;
constexpr Micros latest_after_silence = 4500_us;  // SB-2.12

// H-30: longer than any turn of ours, and with the millisecond until it is seen and the one in which it is switched off
// not longer than 10 ms.
constexpr Millis longest_speech = 8_ms;

// Neutral
constexpr uint8_t neutral_proof = 5;  // SB-01.8: generals in a row

// H-06: generals in a row without the remote's non-critical fault that end its LIMP (SB-00.6)
constexpr uint8_t healthy_proof = 5;

// Speed
constexpr bus::shark::PotReading pot_in_error = bus::shark::PotReading(128);  // SB-00.6: mid-range

// SB-00.5: so long after its last data the programmer counts as active
constexpr Millis programmer_active = 1000_ms;

// Power
constexpr Millis shortest_press = 50_ms;           // SB-4.1
constexpr uint8_t confirm_proof = 2;               // SB-4.3: generals in a row
constexpr Millis lost_link_power_down = 5000_ms;   // SB-4.4
constexpr Millis unconfirmed_power_down = 500_ms;  // SB-4.4
// SB-4.3: the supply waits for the EEPROM, yet not for ever. A record takes 36 ms; at a power-down one or two are
// waiting. What is not written by then is no record.
constexpr Millis longest_store_wait = 170_ms;

// Brakes and motion
constexpr Millis stopped_brake_delay =
    100_ms;  // SB-2.17: brakes at most 250 ms after zero when something forbids to drive
// The gate's own bounds, per millisecond, independent of every setting (SB-2.17, H-33).
constexpr Demand least_fall = Demand(12);     // full speed to zero in 1366 ms
constexpr Demand steepest_rise = Demand(66);  // zero to full speed in 248 ms
constexpr Millis stale_general = 66_ms;  // SB-2.15 once more, for the gate: a general older than this is no command
constexpr Demand limp_ceiling = Demand(8192);  // SB-2.16: no setting lets LIMP exceed half of full voltage

// A coil is a resistor, 0.65 A at 24 V when it is cold. Two of them, however warm, draw more than this, and one alone,
// however cold, less: as many milliamps as the battery has millivolts, by 32.
constexpr uint8_t two_coils_shift = 5;
constexpr Millivolts least_coil_voltage = 16000_mV;  // a battery that says less is not believed

// Outputs against their currents, looked at with every house-keeping; the board reads each sensor twice as often, each
// time from a new conversion.
constexpr uint8_t motor_looks = 4;                  // H-10: in a row, so at least 30 ms
constexpr Milliamps stray_motor_current = 5000_mA;  // H-10: of a motor whose bridge is off
constexpr Milliamps most_motor_current = 80000_mA;  // H-10: beyond its peak of 60 A, whatever is asked of it
constexpr uint8_t bridge_proof = 4;        // H-10: in a row, relay closed and no current, before the first drive
constexpr uint8_t coil_looks = 10;         // H-13: in a row, so 100 ms and not more
constexpr uint8_t coil_proof = 2;          // H-13: in a row with both coils on, before there is torque
constexpr uint8_t lost_coil_looks = 4;     // H-13: in a row, of coils that were on: so all is cut within 60 ms
constexpr Milliamps half_a_coil = 325_mA;  // a coil draws 0.65 A
constexpr Milliamps most_of_two_coils = 2000_mA;

// Motors: 0.15 ohm, 16 A for ever, 60 A for a while (H-31)
constexpr Milliamps motor_peak = 60000_mA;
constexpr Milliamps motor_continuous = 16000_mA;
constexpr uint8_t stall_looks = 30;  // more than those that found it moving, so 300 ms at least

// Battery (H-26)
constexpr Millivolts battery_hysteresis = 500_mV;
constexpr Millivolts most_sag = 4000_mV;  // no load explains more: that is a battery that is worn out
constexpr Milliamps electronics_current = 150_mA;
// Half of full speed needs half the power on the same slope, and still crosses a road.
constexpr Demand low_battery_ceiling = Demand(8192);
constexpr Demand low_battery_step = Demand(82);  // in 100 ms: from full to half in 10 s
constexpr uint16_t gentlest_braking = 1342;      // 1/256 of a step a millisecond: full speed to rest in 3125 ms

// Reports
constexpr uint8_t settings_every = 49;  // SB-0A.1: generals between two settings packets, as real modules do
constexpr Millis longest_without_settings = 1000_ms;  // SB-0A.1
constexpr Millis gauge_settle = 500_ms;               // SB-01.1
constexpr uint8_t gauge_full = 18;                    // SB-01.1
constexpr uint8_t speedo_full = 31;                   // SB-01.7

// SB-2.2: a byte of 286.5 us, and the 50 us between two that the document's examples allow.
constexpr uint16_t slow_byte = 337;  // microseconds
static_assert(bus::shark::Turn::capacity * slow_byte <= 8500, "SB-2.2: so HHP data and settings may share a turn");
// The longest turns of the others: general, HHP data, calibration and TF; general, calibration and TF.
static_assert((9 + 10 + 3 + 1 + bus::shark::Turn::capacity + 8 + 3 + 1) * uint32_t{slow_byte} <= cycle.count() * 1000,
              "SB-2.2: all of them must fit into a cycle");
static_assert(bus::shark::Turn::capacity <= base::TurnSender::capacity, "the longest turn must fit the transmitter");
static_assert(bus::shark::Turn::capacity * uint32_t{287} < (longest_speech.count() - 1) * 1000,
              "H-30: what is cut is no turn");
static_assert(longest_speech + 2_ms <= 10_ms, "H-30");
static_assert(link.silence.count() > 3 * 20000U, "SB-2.15: three cycles of 20 ms and a little more must fit");
static_assert(settings_every * cycle.count() <= longest_without_settings.count(), "SB-0A.1: at least once a second");
static_assert(full_demand.count() / least_fall.count() <= 1500, "SB-2.17: zero within 1500 ms");
static_assert(motor_looks * house_keeping.count() + 5 < 60, "H-10: off within 60 ms");
static_assert(lost_coil_looks * house_keeping.count() + 5 < 60, "H-13: off within 60 ms");
static_assert(stopped_brake_delay <= 250_ms, "SB-2.17");
static_assert(longest_store_wait + house_keeping + house_keeping + house_keeping <= 200_ms,
              "SB-4.3: within 200 ms of the confirm, however late each look at the supply is");

}  // namespace limits
}  // namespace spm
