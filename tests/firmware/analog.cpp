// Starts a conversion, turns to another channel at once, and reads what comes.
#include <avr/io.h>

volatile uint16_t first;      // started on channel 1, ADMUX on channel 2 when read
volatile uint16_t second;     // channel 2
volatile uint16_t too_early;  // read while the second conversion ran
volatile uint16_t left_high;  // ADCH of channel 2, left adjusted
volatile uint16_t duration;   // of a conversion, in CPU cycles
volatile uint8_t flag_before;
volatile uint8_t flag_after;
volatile uint8_t is_done;

static void select(uint8_t channel) {
  ADMUX = static_cast<uint8_t>(_BV(REFS0) | channel);
}

static void finish() {
  while ((ADCSRA & _BV(ADSC)) != 0) {
  }
}

int main() {
  TCCR1B = _BV(CS10);
  const uint8_t on = _BV(ADEN) | _BV(ADPS2) | _BV(ADPS1);
  ADCSRA = on;
  select(1);
  ADCSRA = on | _BV(ADSC);
  select(2);
  finish();
  first = ADC;
  flag_before = ADCSRA & _BV(ADIF);
  ADCSRA = on | _BV(ADIF);
  flag_after = ADCSRA & _BV(ADIF);

  TCNT1 = 0;
  ADCSRA = on | _BV(ADSC);
  too_early = ADC;
  finish();
  duration = TCNT1;
  second = ADC;
  ADMUX = static_cast<uint8_t>(ADMUX | _BV(ADLAR));
  left_high = ADCH;
  is_done = 1;
  for (;;) {
  }
}
