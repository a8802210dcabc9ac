// Interrupts off for a known number of cycles, in the four ways that there are: CLI to SEI, CLI to a restored SREG,
// an interrupt, and an interrupt that lets others in. The bits of EEPROM byte 0 say which of them happen.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>

#define NOPS_10 "nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n"

// 4 cycles to respond, 3 for the vector's JMP, 10 here, 4 for RETI: 21.
ISR(TIMER1_COMPA_vect, ISR_NAKED) {
  __asm__ __volatile__(NOPS_10 "reti\n");
}

// 4, 3, 1 for SEI: 8. Then 30 cycles with interrupts on, CLI, 20 with them off, 4 for RETI: 24, as a handler's time.
ISR(TIMER1_COMPB_vect, ISR_NAKED) {
  __asm__ __volatile__("sei\n" NOPS_10 NOPS_10 NOPS_10 "cli\n" NOPS_10 NOPS_10 "reti\n");
}

// 10 and 1 for SEI: 11.
extern "C" __attribute__((noinline)) void lock_shortly() {
  __asm__ __volatile__("cli\n" NOPS_10 "sei\n");
}

// 30 and 1 for OUT: 31.
extern "C" __attribute__((noinline)) void lock_and_restore() {
  __asm__ __volatile__("in r24, %0\n cli\n" NOPS_10 NOPS_10 NOPS_10 "out %0, r24\n"
                       :
                       : "I"(_SFR_IO_ADDR(SREG))
                       : "r24");
}

int main() {
  const uint8_t ways = eeprom_read_byte(nullptr);
  OCR1A = 1000;
  OCR1B = 2000;
  TIMSK1 = static_cast<uint8_t>(((ways & 4) != 0 ? _BV(OCIE1A) : 0) | ((ways & 8) != 0 ? _BV(OCIE1B) : 0));
  sei();
  if ((ways & 1) != 0) {
    lock_shortly();
  }
  if ((ways & 2) != 0) {
    lock_and_restore();
  }
  TCCR1B = _BV(CS10);
  __asm__ __volatile__("1: rjmp 1b");
}
