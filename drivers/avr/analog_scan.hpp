// The analog scan goes by the tick: each millisecond half of the channels, one after the other.
#pragma once

#include <avr/io.h>
#include <stdint.h>

namespace drivers {
namespace avr {

// 8 MHz / 128: a conversion takes 13 clocks = 208 us, four of them 832 us.
constexpr uint8_t converting = _BV(ADEN) | _BV(ADSC) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
static_assert(F_CPU / 128 >= 50000 && F_CPU / 128 <= 200000, "the converter is exact from 50 to 200 kHz");

// Begins with the channel that is selected.
inline void start_conversion() { ADCSRA = converting; }

}  // namespace avr
}  // namespace drivers
