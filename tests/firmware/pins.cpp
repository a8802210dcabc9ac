// Copies EEPROM bytes 0 to 2 to PORTB, PORTC, PORTD and bytes 3 to 5 to their directions, then reports what
// the pins read, toggling PB1 through PINB all the while if byte 6 is 1.
#include <avr/eeprom.h>
#include <avr/io.h>

volatile uint8_t seen_b;
volatile uint8_t seen_c;
volatile uint8_t seen_d;

static uint8_t setting(uint16_t index) {
  return eeprom_read_byte(reinterpret_cast<const uint8_t*>(index));
}

int main() {
  PORTB = setting(0);
  PORTC = setting(1);
  PORTD = setting(2);
  DDRB = setting(3);
  DDRC = setting(4);
  DDRD = setting(5);
  const bool is_toggling = setting(6) == 1;
  for (;;) {
    if (is_toggling) {
      __asm__ __volatile__("sbi %0, 1" ::"I"(_SFR_IO_ADDR(PINB)));
    }
    PORTC = PORTC;  // a write that must not lift a pin which is held low
    PORTB = PORTB;
    seen_b = PINB;
    seen_c = PINC;
    seen_d = PIND;
  }
}
