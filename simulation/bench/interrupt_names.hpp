// The ATmega1284P's interrupts as its data sheet and avr-libc name them.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace simulation::bench {

inline std::string interrupt_name(std::size_t vector) {
  static constexpr std::array names{
      "RESET",        "INT0",        "INT1",         "INT2",         "PCINT0",       "PCINT1",       "PCINT2",
      "PCINT3",       "WDT",         "TIMER2_COMPA", "TIMER2_COMPB", "TIMER2_OVF",   "TIMER1_CAPT",  "TIMER1_COMPA",
      "TIMER1_COMPB", "TIMER1_OVF",  "TIMER0_COMPA", "TIMER0_COMPB", "TIMER0_OVF",   "SPI_STC",      "USART0_RX",
      "USART0_UDRE",  "USART0_TX",   "ANALOG_COMP",  "ADC",          "EE_READY",     "TWI",          "SPM_READY",
      "USART1_RX",    "USART1_UDRE", "USART1_TX",    "TIMER3_CAPT",  "TIMER3_COMPA", "TIMER3_COMPB", "TIMER3_OVF"};
  return vector < names.size() ? names[vector] : "interrupt " + std::to_string(vector);
}

}  // namespace simulation::bench
