// Motor PWM on both outputs: 300 left, 100 right. EEPROM byte 0: 0 as it should be, 1 directions left as inputs,
// 2 outputs disconnected and the left port bit high, 3 clock stopped, 4 inverted outputs, 5 new value in two halves, 6
// compare values but no mode.
#include <avr/eeprom.h>
#include <avr/io.h>

int main() {
  const uint8_t choice = eeprom_read_byte(reinterpret_cast<const uint8_t*>(0));
  OCR1A = 300;
  OCR1B = 100;
  if (choice == 6) {
    for (;;) {
    }
  }
  TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM11);
  TCCR1B = _BV(WGM12) | _BV(CS10);
  DDRD = _BV(PD5) | _BV(PD4);
  switch (choice) {
    case 1:
      DDRD = 0;
      break;
    case 2:
      PORTD = _BV(PD5);
      TCCR1A = _BV(WGM11);
      break;
    case 3:
      TCCR1B = _BV(WGM12);
      break;
    case 4:
      TCCR1A = _BV(COM1A1) | _BV(COM1A0) | _BV(COM1B1) | _BV(COM1B0) | _BV(WGM11);
      break;
    case 5:
      OCR1AH = 0;
      break;
    default:
      break;
  }
  for (;;) {
  }
}
