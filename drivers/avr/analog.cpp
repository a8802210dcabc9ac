#include "drivers/analog.hpp"

#include <avr/io.h>

namespace drivers {
namespace analog {

namespace {

constexpr uint8_t reference = _BV(REFS0);  // AVCC

// 8 MHz / 128: a conversion takes 13 clocks = 208 us, the first one 400.
constexpr uint8_t converting = _BV(ADEN) | _BV(ADSC) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
static_assert(F_CPU / 128 >= 50000 && F_CPU / 128 <= 200000, "the converter is exact from 50 to 200 kHz");

uint16_t results[channel_count];
uint8_t current;  // being converted, or converted since the last scan()
uint8_t others;   // whose turn it is of those that come round slowly
bool is_complete;

// The four quick ones, then one of the others.
uint8_t channel_after(uint8_t done) {
  if (done < quick_channels - 1) {
    return static_cast<uint8_t>(done + 1);
  }
  return done == quick_channels - 1 ? others : uint8_t{0};
}

// All that the converter depends on: an upset does not last (H-27).
void convert(uint8_t channel) {
  ADMUX = static_cast<uint8_t>(reference | channel);
  ADCSRB = 0;
  ADCSRA = converting;
}

}  // namespace

void start() {
  current = 0;
  others = quick_channels;
  is_complete = false;
  DIDR0 = 0xFF;  // all of port A is analog
  convert(current);
}

void scan() {
  if ((ADCSRA & _BV(ADSC)) != 0) {
    return;
  }
  results[current] = ADC;
  if (current >= quick_channels) {
    is_complete = is_complete || current == channel_count - 1;
    others = current < channel_count - 1 ? static_cast<uint8_t>(current + 1) : quick_channels;
  }
  current = channel_after(current);
  convert(current);
}

uint16_t raw(Channel channel) {
  return results[static_cast<uint8_t>(channel)];
}

bool is_ready() {
  return is_complete;
}

}  // namespace analog
}  // namespace drivers
