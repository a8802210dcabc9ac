// The monitor's figures, each with its source, and its tolerances. Written a second time from the document: nothing
// here may be taken from the firmware's own limits. Where the firmware has a setting, its default is assumed.
#pragma once

#include "simulation/time.hpp"

namespace simulation::monitor::limits {

// Motion
constexpr int full_duty = 511;
constexpr int neutral_reading = 512;      // SB-00.8
constexpr int deadband = 30;              // SB-00.8
constexpr int proof = 5;                  // SB-01.8, SB-2.16: generals in a row
constexpr Time silence = 62ms;            // SB-2.15: the latest end of 60 ms
constexpr int corrupt_run = 3;            // SB-2.14
constexpr Time reaction = 5ms;            // from what takes drive away to the last duty that may still grow
constexpr Time emergency_stop = 1500ms;   // SB-2.17: from full speed to zero
constexpr Time slowest_release = 3125ms;  // full speed to zero by the slower of the normal ramps, that in reverse
constexpr Time steepest = 248ms;          // H-33: nothing takes less between zero and full speed
constexpr Time held_up = 4ms;             // a wheel's steps may wait that long for the bus, and are then made at once
constexpr int rounding = 2;               // steps of a duty
constexpr int made_up_at_once = 8;        // steps of a duty within `held_up`
constexpr int limp_duty = 209;            // 41 % of full (SB-2.16: default 40 %)
constexpr Time limp_ramp = 1500ms;        // from LIMP's cause to the cap

// Currents: 16 A for ever, 60 A at most; the sensors end at 100 A (H-31)
constexpr double peak_amperes = 60;
constexpr double peak_amperes_held = 62;  // a sensor's step of 0.25 A, and what a ramp adds between two looks
constexpr double most_amperes = 80;       // beyond this it is a stuck output (H-10)
constexpr Time current_reaction = 25ms;   // two looks, 10 ms apart, and a reading that may be 5 ms old
constexpr Time longest_overload = 60ms;   // H-10: and then bridge, relay and brakes are off

// Brakes
constexpr Time brake_release = 98ms;       // coil on to torque: 100 ms less two samples
constexpr Time brakes_after_stop = 250ms;  // SB-2.17
constexpr Time brakes_at_rest = 850ms;     // engage time 800 ms and a margin

// Power
constexpr Time latch = 20ms;           // H-15, SB-1.2
constexpr Time press_possible = 48ms;  // SB-4.1: 50 ms of a millisecond clock
constexpr Time press_certain = 52ms;
constexpr int confirms = 2;          // SB-4.3
constexpr Time lost_least = 4980ms;  // SB-4.4
constexpr Time lost_most = 5020ms;
constexpr Time unconfirmed_least = 480ms;  // SB-4.4
constexpr Time unconfirmed_most = 520ms;
constexpr Time power_down = 200ms;  // SB-4.3: of confirm or of brakes engaged
constexpr Time sleep = 15min - 1s;  // SB-4.2

// Bus
constexpr Time turn = 25ms;  // a cycle of 20 ms and the answer's way
constexpr Time latest_after_finish = 1600us;
constexpr Time earliest_after_finish = -26us;    // a slow peer's last stop bit is recessive anyway
constexpr Time earliest_after_silence = 2950us;  // SB-2.12, as a receiver with a clock of its own counts it
constexpr Time latest_after_silence = 4600us;
constexpr Time on_time = 10ms;  // H-30: in any `on_time_window`
constexpr Time on_time_window = 20ms;
constexpr Time speech_gap = 500us;      // a longer pause begins a new turn
constexpr Time wake_latency = 1200us;   // two characters may already be on their way
constexpr Time lamps_off = 100ms;       // SB-00.3
constexpr Time actuators_off = 100ms;   // H-18
constexpr Time actuator_pause = 400ms;  // between extend and retract
constexpr Time actuator_longest = 61s;  // in one go
constexpr Time lock_gives_up = 9900ms;  // still locked after 10 s: power-down may be asked for

}  // namespace simulation::monitor::limits
