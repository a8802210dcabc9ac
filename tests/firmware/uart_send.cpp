// Sends five characters as fast as the transmitter takes them. EEPROM byte 0 chooses the frame.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint8_t complete;  // transmit-complete interrupts

ISR(USART0_TX_vect) {
  complete = static_cast<uint8_t>(complete + 1);
}

int main() {
  const uint8_t choice = eeprom_read_byte(reinterpret_cast<const uint8_t*>(0));
  const uint8_t eight_bits_two_stops = _BV(UCSZ01) | _BV(UCSZ00) | _BV(USBS0);
  switch (choice) {
    case 0:  // 8N2, baud rate first
      UBRR0L = 12;
      UCSR0C = eight_bits_two_stops;
      break;
    case 1:  // 8N2, baud rate last
      UCSR0C = eight_bits_two_stops;
      UBRR0L = 12;
      break;
    case 2:  // 8N1
      UBRR0L = 12;
      UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
      break;
    case 3:  // 8E2
      UBRR0L = 12;
      UCSR0C = eight_bits_two_stops | _BV(UPM01);
      break;
    default:  // 8N2 at double speed
      UCSR0A = _BV(U2X0);
      UBRR0L = 25;
      UCSR0C = eight_bits_two_stops;
      break;
  }
  UCSR0B = _BV(TXEN0) | _BV(TXCIE0);
  sei();
  for (uint8_t i = 0; i < 5; ++i) {
    while ((UCSR0A & _BV(UDRE0)) == 0) {
    }
    UDR0 = static_cast<uint8_t>(0x10 + i);
  }
  for (;;) {
  }
}
