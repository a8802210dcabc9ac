// One-shot compares on timer 3's channel B, while the tick of timer 0 moves channel A: none may get lost.
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint16_t asked;
volatile uint16_t fired;
volatile uint16_t lost;

ISR(TIMER0_COMPA_vect) {
  OCR3A = static_cast<uint16_t>(TCNT3 + 50U);
}

ISR(TIMER3_COMPA_vect) {}

ISR(TIMER3_COMPB_vect) {
  TIMSK3 = _BV(OCIE3A);
  fired = static_cast<uint16_t>(fired + 1);
}

static uint16_t stamp() {
  cli();
  const uint16_t now = TCNT3;
  sei();
  return now;
}

int main() {
  OCR0A = 12;  // 104 us: often
  TCCR0A = _BV(WGM01);
  TCCR0B = _BV(CS01) | _BV(CS00);
  TIMSK0 = _BV(OCIE0A);
  TCCR3B = _BV(CS31);
  TIMSK3 = _BV(OCIE3A);
  for (;;) {
    cli();
    asked = static_cast<uint16_t>(asked + 1);
    const uint16_t before = fired;
    const uint16_t start = TCNT3;
    OCR3B = static_cast<uint16_t>(start + 30U + (asked & 63U));
    TIFR3 = _BV(OCF3B);
    TIMSK3 = _BV(OCIE3A) | _BV(OCIE3B);
    sei();
    while (fired == before && stamp() - start < 200U) {
    }
    if (fired == before) {
      lost = static_cast<uint16_t>(lost + 1);
    }
  }
}
