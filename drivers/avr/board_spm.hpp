// The pin map of the SPM board on an ATmega1284P: the only file that names a port.
#pragma once

#include <avr/io.h>
#include <stdint.h>

namespace drivers {
namespace avr {

// A pin's three registers lie side by side: PIN, DDR, PORT.
template <uint8_t pin_register, uint8_t bit>
struct Pin {
  static constexpr uint8_t mask = static_cast<uint8_t>(1U << bit);

  __attribute__((always_inline)) static volatile uint8_t& input() { return _SFR_IO8(pin_register); }
  __attribute__((always_inline)) static volatile uint8_t& direction() { return _SFR_IO8(pin_register + 1); }
  __attribute__((always_inline)) static volatile uint8_t& output() { return _SFR_IO8(pin_register + 2); }

  // One instruction each (sbi, cbi), so no interrupt can fall in between.
  __attribute__((always_inline)) static void set() { output() |= mask; }
  __attribute__((always_inline)) static void clear() { output() &= static_cast<uint8_t>(~mask); }
  __attribute__((always_inline)) static void write(bool level) {
    if (level) {
      set();
    } else {
      clear();
    }
  }
  __attribute__((always_inline)) static bool is_high() { return (input() & mask) != 0; }
  __attribute__((always_inline)) static void make_output() { direction() |= mask; }
  __attribute__((always_inline)) static void make_input() { direction() &= static_cast<uint8_t>(~mask); }
};

// Register addresses in I/O space of PINA, PINB, PINC, PIND.
constexpr uint8_t port_a = 0x00;
constexpr uint8_t port_b = 0x03;
constexpr uint8_t port_c = 0x06;
constexpr uint8_t port_d = 0x09;

using BusReceive = Pin<port_d, 0>;
using BusTransmit = Pin<port_d, 1>;  // idle high = recessive
using Wake = Pin<port_b, 2>;         // high while SBH is above 12 V
using PowerLatch = Pin<port_c, 6>;

using BridgeEnable = Pin<port_c, 7>;
using MotorRelay = Pin<port_b, 5>;
using PwmLeft = Pin<port_d, 5>;   // OC1A
using PwmRight = Pin<port_d, 4>;  // OC1B
using LeftForward = Pin<port_d, 6>;
using RightForward = Pin<port_d, 7>;
using LeftBrakeRelease = Pin<port_c, 0>;
using RightBrakeRelease = Pin<port_c, 1>;

using LeftIndicator = Pin<port_c, 2>;
using RightIndicator = Pin<port_c, 3>;
using Headlight = Pin<port_c, 4>;
using Actuator1Extend = Pin<port_b, 3>;
using Actuator1Retract = Pin<port_b, 4>;
using Actuator2Extend = Pin<port_b, 6>;
using Actuator2Retract = Pin<port_b, 7>;
using StatusLed = Pin<port_b, 1>;

using DciSlowdown = Pin<port_b, 0>;    // pulled up; low = slow
using LightingStrap = Pin<port_c, 5>;  // pulled up; low = lighting fitted

// The switched outputs as bits of their ports, and the pull-ups, which stay.
constexpr uint8_t switched_b =
    Actuator1Extend::mask | Actuator1Retract::mask | Actuator2Extend::mask | Actuator2Retract::mask | StatusLed::mask;
constexpr uint8_t pulled_up_b = DciSlowdown::mask;
constexpr uint8_t switched_c = LeftIndicator::mask | RightIndicator::mask | Headlight::mask;
constexpr uint8_t pulled_up_c = LightingStrap::mask;

// Which pins are outputs, of all ports at once.
inline void write_directions() {
  BusTransmit::set();  // SB-1.1: recessive before the pin drives
  DDRA = 0;
  DDRB = switched_b | MotorRelay::mask;
  DDRC = switched_c | LeftBrakeRelease::mask | RightBrakeRelease::mask | PowerLatch::mask | BridgeEnable::mask;
  DDRD = BusTransmit::mask | PwmLeft::mask | PwmRight::mask | LeftForward::mask | RightForward::mask;
}

}  // namespace avr
}  // namespace drivers
