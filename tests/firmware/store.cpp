// Writes to the EEPROM. Byte 0 chooses: 0 two bytes and the time they take, 1 a write-only 0x3F over byte 20,
// 2 three bytes from the EE_READY interrupt, 3 a single byte whose write nobody waits for.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>

volatile uint16_t elapsed_us;
volatile uint8_t was_busy;
volatile uint8_t ready_count;
volatile uint8_t is_done;

static uint8_t* cell(uint16_t address) {
  return reinterpret_cast<uint8_t*>(address);
}

static void write(uint16_t address, uint8_t value, uint8_t mode) {
  EEAR = address;
  EEDR = value;
  EECR = static_cast<uint8_t>((EECR & _BV(EERIE)) | mode);
  __asm__ __volatile__("sbi %0, %1\n sbi %0, %2" ::"I"(_SFR_IO_ADDR(EECR)), "I"(EEMPE), "I"(EEPE));
}

ISR(EE_READY_vect) {
  if (ready_count < 3) {
    write(static_cast<uint16_t>(30 + ready_count), static_cast<uint8_t>(0x70 + ready_count), 0);
    ready_count = static_cast<uint8_t>(ready_count + 1);
  } else {
    EECR = 0;
    is_done = 1;
  }
}

int main() {
  const uint8_t choice = eeprom_read_byte(cell(0));
  TCCR1B = _BV(CS11);
  if (choice == 0) {
    TCNT1 = 0;
    eeprom_write_byte(cell(10), 0xA5);
    was_busy = !eeprom_is_ready();
    eeprom_write_byte(cell(11), 0x5A);
    eeprom_busy_wait();
    elapsed_us = TCNT1;
    is_done = 1;
  } else if (choice == 1) {
    write(20, 0x3F, _BV(EEPM1));
    eeprom_busy_wait();
    elapsed_us = TCNT1;
    is_done = 1;
  } else if (choice == 2) {
    sei();
    EECR = _BV(EERIE);
  } else {
    write(40, 0x11, 0);
    is_done = 1;
  }
  for (;;) {
  }
}
