#include "drivers/analog.hpp"

#include <avr/io.h>

#include "drivers/base/scan_order.hpp"

namespace drivers {
namespace analog {

namespace {

constexpr uint8_t reference = _BV(REFS0);  // AVCC

// 8 MHz / 128: a conversion takes 13 clocks = 208 us, the first one 400.
constexpr uint8_t converting = _BV(ADEN) | _BV(ADSC) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
static_assert(F_CPU / 128 >= 50000 && F_CPU / 128 <= 200000, "the converter is exact from 50 to 200 kHz");

uint16_t results[channel_count];
base::ScanOrder<quick_channels, channel_count> order;  // at what is being converted, or was since the last scan()

// All that the converter depends on: an upset does not last (H-27).
void convert(uint8_t channel) {
  ADMUX = static_cast<uint8_t>(reference | channel);
  ADCSRB = 0;
  ADCSRA = converting;
}

}  // namespace

void start() {
  order = base::ScanOrder<quick_channels, channel_count>();
  DIDR0 = 0xFF;  // all of port A is analog
  convert(order.current());
}

void scan() {
  if ((ADCSRA | _BV(ADIF)) == (converting | _BV(ADIF))) {
    return;  // not finished; an upset that would let it never finish does not count as that (H-27)
  }
  results[order.current()] = ADC;
  order.advance();
  convert(order.current());
}

uint16_t raw(Channel channel) {
  return results[static_cast<uint8_t>(channel)];
}

bool is_ready() {
  return order.is_complete();
}

}  // namespace analog
}  // namespace drivers
