// Interrupt flags that are up before anybody enables their interrupts, and how they are cleared.
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint8_t all;           // TIFR0 with all three flags up
volatile uint8_t after_write;   // after writing one to OCF0A
volatile uint8_t after_sbi;     // after SBI on OCF0B
volatile uint8_t timer_asked;   // interrupts of a flag that was cleared before it could be served
volatile uint8_t timer_fired;   // the overflow flag, enabled late
volatile uint8_t wake_up;       // EIFR after an edge on WAKE
volatile uint8_t wake_cleared;  // after writing one to INTF2
volatile uint8_t wake_fired;    // interrupts of INT2
volatile uint8_t is_done;

ISR(TIMER0_OVF_vect) {
  timer_fired = static_cast<uint8_t>(timer_fired + 1);
}

ISR(TIMER0_COMPA_vect) {
  timer_asked = static_cast<uint8_t>(timer_asked + 1);
}

ISR(INT2_vect) {
  wake_fired = static_cast<uint8_t>(wake_fired + 1);
}

static void wait_for_wake(bool level) {
  while (((PINB & _BV(PB2)) != 0) != level) {
  }
}

int main() {
  OCR0A = 20;
  OCR0B = 30;
  TCCR0B = _BV(CS00);
  while ((TIFR0 & _BV(TOV0)) == 0) {
  }
  TCCR0B = 0;
  all = TIFR0;
  TIFR0 = _BV(OCF0A);
  after_write = TIFR0;
  __asm__ __volatile__("sbi %0, %1" ::"I"(_SFR_IO_ADDR(TIFR0)), "I"(OCF0B));
  after_sbi = TIFR0;
  TCCR0B = _BV(CS00);
  while ((TIFR0 & _BV(OCF0A)) == 0) {
  }
  TCCR0B = 0;
  TIMSK0 = _BV(OCIE0A);
  TIFR0 = _BV(OCF0A);
  sei();
  __asm__ __volatile__("nop\n nop\n nop");
  TIMSK0 = _BV(TOIE0);
  __asm__ __volatile__("nop\n nop\n nop");
  TIMSK0 = 0;

  EICRA = _BV(ISC21) | _BV(ISC20);
  wait_for_wake(true);
  wake_up = EIFR;
  EIFR = _BV(INTF2);
  wake_cleared = EIFR;
  wait_for_wake(false);
  wait_for_wake(true);
  EIMSK = _BV(INT2);
  __asm__ __volatile__("nop\n nop\n nop");
  is_done = 1;
  for (;;) {
  }
}
