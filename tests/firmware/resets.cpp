// Says why it started, then does as EEPROM byte 0 tells: 0 feeds the watchdog, 1 stops feeding it after 100 ms,
// 2 writes beyond RAM, 3 sleeps with interrupts off, 4 jumps into erased flash, 5 as 0 but leaves the causes of
// resets standing.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

volatile uint8_t causes;
volatile uint8_t starts __attribute__((section(".noinit")));  // survives all but power-on
volatile uint16_t ticks;

ISR(TIMER0_COMPA_vect) {
  ticks = static_cast<uint16_t>(ticks + 1);
}

int main() {
  const uint8_t choice = eeprom_read_byte(reinterpret_cast<const uint8_t*>(0));
  causes = MCUSR;
  if (choice != 5) {
    MCUSR = 0;
  }
  wdt_enable(WDTO_30MS);
  starts = static_cast<uint8_t>((causes & _BV(PORF)) != 0 ? 1 : starts + 1);
  DDRC = _BV(PC6);
  PORTC = _BV(PC6) | _BV(PC5);
  OCR0A = 124;
  TCCR0A = _BV(WGM01);
  TCCR0B = _BV(CS01) | _BV(CS00);
  TIMSK0 = _BV(OCIE0A);
  sei();
  while (ticks < 100 || choice == 0 || choice == 5) {
    wdt_reset();
  }
  if (choice == 2) {
    *reinterpret_cast<volatile uint8_t*>(0x5000) = 1;
  } else if (choice == 3) {
    sleep_enable();
    cli();
    sleep_cpu();
  } else if (choice == 4) {
    void (*nowhere)() = reinterpret_cast<void (*)()>(0x4000);
    nowhere();
  }
  for (;;) {
  }
}
