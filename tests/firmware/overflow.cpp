// One mistake, chosen by EEPROM byte 0: 1 a signed sum beyond 16 bits, 2 a shift by more than there are bits, 3 an
// index behind the end of an array, 4 a signed product beyond 16 bits; 0 none.
#include <avr/eeprom.h>
#include <stdint.h>

volatile int16_t large = 30000;
volatile uint8_t far = 16;
volatile uint8_t behind = 4;
volatile int16_t result;
volatile uint8_t is_done;

static uint8_t table[4] = {1, 2, 3, 4};

int main() {
  const uint8_t choice = eeprom_read_byte(reinterpret_cast<const uint8_t*>(0));
  switch (choice) {
    case 1:
      result = static_cast<int16_t>(large + large);
      break;
    case 2:
      result = static_cast<int16_t>(1 << far);
      break;
    case 3:
      result = table[behind];
      break;
    case 4:
      result = static_cast<int16_t>(large * large);
      break;
    default:
      result = static_cast<int16_t>(large - large);
      break;
  }
  is_done = 1;
  for (;;) {
  }
}
