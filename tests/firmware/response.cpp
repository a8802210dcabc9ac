// How long an interrupt takes to be served: reads the counter first thing after a compare match at 1000.
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint8_t latency[2];  // timer 1 at the first instruction behind the vector's jump

ISR(TIMER1_COMPA_vect, ISR_NAKED) {
  __asm__ __volatile__(
      "lds r24, %1\n"
      "lds r25, %1 + 1\n"
      "sts %0, r24\n"
      "sts %0 + 1, r25\n"
      "reti\n"
      :
      : "i"(latency), "i"(_SFR_MEM_ADDR(TCNT1)));
}

int main() {
  TIMSK1 = _BV(OCIE1A);
  OCR1A = 1000;
  TCCR1B = _BV(CS10);
  sei();
  __asm__ __volatile__("1: rjmp 1b");
}
