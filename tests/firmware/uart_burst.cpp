// Sends ten characters from the data-register-empty interrupt, again whenever WAKE rises.
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint8_t complete;
volatile uint8_t empty;  // data-register-empty interrupts
static volatile uint8_t next;

ISR(USART0_UDRE_vect) {
  empty = static_cast<uint8_t>(empty + 1);
  if (next < 10) {
    UDR0 = next;
    next = static_cast<uint8_t>(next + 1);
  } else {
    UCSR0B = static_cast<uint8_t>(UCSR0B & ~_BV(UDRIE0));
  }
}

ISR(USART0_TX_vect) {
  complete = static_cast<uint8_t>(complete + 1);
}

int main() {
  UBRR0L = 12;
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00) | _BV(USBS0);
  UCSR0B = _BV(TXEN0) | _BV(TXCIE0);
  sei();
  for (;;) {
    while ((PINB & _BV(PB2)) == 0) {
    }
    next = 0;
    UCSR0B = static_cast<uint8_t>(UCSR0B | _BV(UDRIE0));
    while ((PINB & _BV(PB2)) != 0) {
    }
  }
}
