// Sleeps until WAKE changes.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

volatile uint8_t edges;
volatile uint8_t passes;
volatile uint8_t seen_first;  // edges known to the first instruction after the first sleep

ISR(INT2_vect) {
  edges = static_cast<uint8_t>(edges + 1);
}

int main() {
  EICRA = _BV(ISC20);
  EIFR = _BV(INTF2);
  EIMSK = _BV(INT2);
  sleep_enable();
  for (;;) {
    __asm__ __volatile__("sei\n sleep\n cli" ::: "memory");
    if (passes == 0) {
      seen_first = edges;
    }
    passes = static_cast<uint8_t>(passes + 1);
  }
}
