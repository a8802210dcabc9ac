#include "drivers/analog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/avr/interrupt_lock.hpp"

namespace {

using drivers::analog::channel_count;

constexpr uint8_t reference = _BV(REFS0);  // AVCC
// 8 MHz / 128: a conversion takes 13 clocks = 208 us, so every channel is renewed each 1.7 ms.
constexpr uint8_t converting = _BV(ADEN) | _BV(ADSC) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
static_assert(F_CPU / 128 >= 50000 && F_CPU / 128 <= 200000, "the converter is exact from 50 to 200 kHz");

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
  ADCSRA = converting;
}

namespace drivers {
namespace analog {

void start() {
  current = 0;
  is_complete = false;
  DIDR0 = 0xFF;  // all of port A is analog
  ADMUX = reference;
  ADCSRA = converting;
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
