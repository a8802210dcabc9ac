// Sleeps until WAKE changes.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

volatile uint8_t edges;

ISR(INT2_vect) {
  edges = static_cast<uint8_t>(edges + 1);
}

int main() {
  EICRA = _BV(ISC20);
  EIFR = _BV(INTF2);
  EIMSK = _BV(INT2);
  sleep_enable();
  sei();
  for (;;) {
    sleep_cpu();
  }
}
