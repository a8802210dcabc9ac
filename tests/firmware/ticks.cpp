// Counts timer ticks of 1 ms, asleep in between. EEPROM byte 0: 0 sleeps between SEI and CLI, 1 has a NOP there,
// 2 forgets to enable sleep.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

volatile uint16_t ticks;
volatile uint16_t loops;
volatile uint8_t signature = 0x5A;  // an initialised variable: copied from flash at the start

ISR(TIMER0_COMPA_vect) {
  ticks = static_cast<uint16_t>(ticks + 1);
}

int main() {
  const uint8_t choice = eeprom_read_byte(reinterpret_cast<const uint8_t*>(0));
  static_cast<void>(signature);
  OCR0A = 124;
  TCCR0A = _BV(WGM01);
  TCCR0B = _BV(CS01) | _BV(CS00);
  TIMSK0 = _BV(OCIE0A);
  SMCR = 0;  // idle
  if (choice != 2) {
    sleep_enable();
  }
  for (;;) {
    if (choice == 1) {
      __asm__ __volatile__("sei\n nop\n cli" ::: "memory");
    } else {
      __asm__ __volatile__("sei\n sleep\n cli" ::: "memory");
    }
    loops = static_cast<uint16_t>(loops + 1);
  }
}
