#include "drivers/analog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/avr/analog_scan.hpp"
#include "drivers/avr/interrupt_lock.hpp"

namespace {

using drivers::analog::channel_count;

constexpr uint8_t reference = _BV(REFS0);  // AVCC
constexpr uint8_t channels_of_a_tick = 4;

volatile uint16_t results[channel_count];
volatile uint8_t current;
volatile bool is_complete;

}  // namespace

ISR(ADC_vect) {
  const uint8_t done = current;
  results[done] = ADC;
  const uint8_t next = static_cast<uint8_t>((done + 1U) & (channel_count - 1U));
  if (next == 0) {
    is_complete = true;
  }
  current = next;
  ADMUX = static_cast<uint8_t>(reference | next);
  if (next % channels_of_a_tick != 0) {
    drivers::avr::start_conversion();
  }
}

namespace drivers {
namespace analog {

void start() {
  current = 0;
  is_complete = false;
  DIDR0 = 0xFF;  // all of port A is analog
  ADMUX = reference;
}

uint16_t raw(Channel channel) {
  avr::InterruptLock lock;
  return results[static_cast<uint8_t>(channel)];
}

bool is_ready() {
  return is_complete;
}

}  // namespace analog
}  // namespace drivers
