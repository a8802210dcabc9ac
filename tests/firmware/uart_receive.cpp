// Receives: by polling while WAKE is high, or one character an interrupt if EEPROM byte 0 is 1.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint8_t count;
volatile uint8_t values[32];
volatile uint8_t states[32];  // UCSR0A as it was read before each character

static void take() {
  if (count < 32) {
    states[count] = UCSR0A;
    values[count] = UDR0;
    count = static_cast<uint8_t>(count + 1);
  }
}

ISR(USART0_RX_vect) {
  take();
}

int main() {
  UBRR0L = 12;
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00) | _BV(USBS0);
  UCSR0B = _BV(RXEN0);
  if (eeprom_read_byte(reinterpret_cast<const uint8_t*>(0)) == 1) {
    UCSR0B = _BV(RXEN0) | _BV(RXCIE0);
    sei();
  }
  for (;;) {
    if ((PINB & _BV(PB2)) == 0) {
      continue;
    }
    if ((UCSR0B & _BV(RXCIE0)) != 0) {
      cli();  // deaf as long as WAKE is high
      while ((PINB & _BV(PB2)) != 0) {
      }
      sei();
    } else if ((UCSR0A & _BV(RXC0)) != 0) {
      take();
    }
  }
}
