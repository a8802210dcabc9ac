// What the image does before its variables are there, and what it keeps of that: the tests of flash and RAM, the bytes
// that outlive a reset, the guard below the stack.
//
//   .init3  latch held (power_latch.cpp), cause of the reset saved in GPIOR1, watchdog at 500 ms (watchdog.cpp)
//   .init4  test_memory(), here; then the loader's copying of .data and clearing of .bss, which lie behind it in .init4
//
// The flash first: what tests it stores nothing, so a wrong bit in it can do no harm, and what stores runs only from a
// flash that is known to be right. The result lives in an I/O register, because RAM may be what is broken.
#include <avr/io.h>
#include <util/crc16.h>

#include "drivers/avr/board_spm.hpp"
#include "drivers/base/flash.hpp"
#include "drivers/retained.hpp"
#include "drivers/self_test.hpp"

namespace {

// GPIOR2. Far from each other and from what a reset leaves there, so that no single bit makes a failure a pass.
constexpr uint8_t all_passed = 0x5A;
constexpr uint8_t flash_failed = 0x3C;
constexpr uint8_t flash_failed_later = 0xC3;
constexpr uint8_t ram_failed = 0x00;

constexpr uint8_t guard_byte = 0xA9;
constexpr uint8_t guard_size = 16;      // as far as a stack that goes too deep is noticed before it does harm
constexpr uint8_t guard_looked_at = 8;  // those next to the variables

constexpr uint16_t crc_at_start = 0xFFFF;
// Not what comes out of erased flash alone, should the test run over less than it ought to. As in drivers/avr/checksum.
constexpr uint16_t crc_at_end = 0x6996;

drivers::retained::Bytes kept __attribute__((section(".noinit")));

const uint8_t* next_byte;  // of the round that is going on
uint16_t round_crc;

}  // namespace

extern "C" uint8_t _end[];  // the linker's: the first byte behind all variables

// H-27: CRC-16 over the flash; then, if that is right, March C- over all of RAM, the stack's included, in registers
// only: each cell is written and read back as 0 and as 1 while its neighbours above and below are the one and the
// other. That finds every bit that is stuck, cannot rise or cannot fall, every address that means another cell, and
// every pair of bytes of which one disturbs the other. The pattern alternates, so it finds neighbours in a byte that
// are shorted; four more patterns do it for the other pairs.
//
// 0xF0 is what stays behind. Afterwards the guard is written. Flash 103 ms, RAM 122 ms.
extern "C" void test_memory() __attribute__((naked, used, section(".init4")));
extern "C" void test_memory() {
  __asm__ __volatile__(
      ".macro next_byte\n\t"  // _crc_ccitt_update of avr-libc
      "lpm r19, Z+\n\t"
      "eor r24, r19\n\t"
      "mov r0, r24\n\t"
      "swap r24\n\t"
      "andi r24, 0xF0\n\t"
      "eor r24, r0\n\t"
      "mov r0, r25\n\t"
      "mov r25, r24\n\t"
      "swap r24\n\t"
      "andi r24, 0x0F\n\t"
      "eor r0, r24\n\t"
      "lsr r24\n\t"
      "eor r25, r24\n\t"
      "eor r24, r25\n\t"
      "lsl r24\n\t"
      "lsl r24\n\t"
      "lsl r24\n\t"
      "eor r24, r0\n\t"
      ".endm\n\t"

      "ldi r30, 0\n\t"
      "ldi r31, 0\n\t"
      "ldi r24, %[seed]\n\t"
      "ldi r25, %[seed]\n"
      "1:\n\t"
      "next_byte\n\t"
      "next_byte\n\t"
      "cpi r31, %[checked]\n\t"
      "brne 1b\n\t"
      "ldi r19, lo8(%[right])\n\t"
      "eor r24, r19\n\t"
      "ldi r19, hi8(%[right])\n\t"
      "eor r25, r19\n\t"
      "or r24, r25\n\t"
      "mov r6, r24\n\t"  // kept: it is asked twice, so that no single wrong bit makes this a pass
      "breq 2f\n\t"
      "ldi r24, %[flash_failed]\n\t"
      "rjmp 3f\n"
      "2:\n\t"
      // The retained bytes survive in r2 to r5.
      "ldi r30, lo8(%[kept])\n\t"
      "ldi r31, hi8(%[kept])\n\t"
      "ld r2, Z\n\t"
      "ldd r3, Z+1\n\t"
      "ldd r4, Z+2\n\t"
      "ldd r5, Z+3\n\t"
      "ldi r16, 0x55\n\t"  // a cell that holds 0
      "ldi r17, 0xAA\n\t"  // a cell that holds 1
      "clr r18\n\t"        // every bit that ever differed
      "ldi r20, %[first]\n\t"
      "ldi r22, 0x33\n\t"
      "ldi r23, 0xCC\n\t"
      "ldi r24, 0x0F\n\t"
      "ldi r25, 0xF0\n\t"

      ".macro compare pattern\n\t"
      "eor r19, \\pattern\n\t"
      "or r18, r19\n\t"
      ".endm\n\t"

      ".macro upwards is, becomes\n\t"
      "ldi r30, 0\n\t"
      "ldi r31, %[first]\n"
      "1:\n\t"
      ".rept 8\n\t"
      "ld r19, Z\n\t"
      "compare \\is\n\t"
      "st Z+, \\becomes\n\t"
      ".endr\n\t"
      "cpi r31, %[behind]\n\t"
      "brne 1b\n\t"
      ".endm\n\t"

      ".macro downwards is, becomes\n\t"
      "ldi r30, 0\n\t"
      "ldi r31, %[behind]\n"
      "1:\n\t"
      ".rept 8\n\t"
      "ld r19, -Z\n\t"
      "compare \\is\n\t"
      "st Z, \\becomes\n\t"
      ".endr\n\t"
      "cpi r30, 0\n\t"
      "cpc r31, r20\n\t"
      "brne 1b\n\t"
      ".endm\n\t"

      ".macro try pattern\n\t"
      "st Z, \\pattern\n\t"
      "ld r19, Z\n\t"
      "compare \\pattern\n\t"
      ".endm\n\t"

      "ldi r30, 0\n\t"
      "ldi r31, %[first]\n"
      "1:\n\t"
      ".rept 8\n\t"
      "st Z+, r16\n\t"
      ".endr\n\t"
      "cpi r31, %[behind]\n\t"
      "brne 1b\n\t"

      "upwards r16, r17\n\t"
      "upwards r17, r16\n\t"
      "downwards r16, r17\n\t"
      "downwards r17, r16\n\t"

      "ldi r30, 0\n\t"
      "ldi r31, %[first]\n"
      "1:\n\t"
      ".rept 2\n\t"
      "ld r19, Z\n\t"
      "compare r16\n\t"
      "try r22\n\t"
      "try r23\n\t"
      "try r24\n\t"
      "try r25\n\t"
      "adiw r30, 1\n\t"
      ".endr\n\t"
      "cpi r31, %[behind]\n\t"
      "brne 1b\n\t"

      "ldi r30, lo8(%[kept])\n\t"
      "ldi r31, hi8(%[kept])\n\t"
      "st Z, r2\n\t"
      "std Z+1, r3\n\t"
      "std Z+2, r4\n\t"
      "std Z+3, r5\n\t"

      "ldi r24, %[passed]\n\t"
      "tst r18\n\t"
      "breq 1f\n\t"
      "ldi r24, %[ram_failed]\n"
      "1:\n\t"
      "tst r6\n\t"
      "breq 3f\n\t"
      "ldi r24, %[flash_failed]\n"
      "3:\n\t"
      "out %[result], r24\n\t"
      "cpi r24, %[passed]\n\t"
      "breq 5f\n\t"
      // A chip that fails runs no program: what a wrong bit makes of one, nobody knows. The pins stay as the reset left
      // them, the LED is lit, the watchdog off; the supply is let go 5 s after the reset, as if the remote were gone
      // (SB-4.4): rounds of 32.8 ms, fewer after the longer test.
      "ldi r24, %[change]\n\t"
      "clr r25\n\t"
      "wdr\n\t"
      "sts %[watchdog], r24\n\t"
      "sts %[watchdog], r25\n\t"
      "sbi %[led_direction], %[led_bit]\n\t"
      "sbi %[led], %[led_bit]\n\t"
      "in r24, %[result]\n\t"
      "ldi r25, %[after_ram]\n\t"
      "cpi r24, %[ram_failed]\n\t"
      "breq 4f\n\t"
      "ldi r25, %[after_flash]\n"
      "4:\n\t"
      "ldi r30, 0\n\t"
      "ldi r31, 0\n"
      "6:\n\t"
      "sbiw r30, 1\n\t"
      "brne 6b\n\t"
      "dec r25\n\t"
      "brne 4b\n\t"
      "cbi %[latch], %[latch_bit]\n"
      "7:\n\t"
      "rjmp 7b\n"
      "5:\n\t"

      "ldi r30, lo8(_end)\n\t"
      "ldi r31, hi8(_end)\n\t"
      "ldi r24, %[guard]\n\t"
      "ldi r25, %[guards]\n"
      "1:\n\t"
      "st Z+, r24\n\t"
      "dec r25\n\t"
      "brne 1b\n\t"
      "rjmp 1f\n"
      // Two bytes of the image that a tool chooses so that the checksum over all of it comes out right
      // (drivers/avr/checksum).
      ".global image_checksum\n"
      ".global image_checked_bytes\n"
      ".set image_checked_bytes, %[checked_bytes]\n"
      "image_checksum:\n\t"
      ".word 0xFFFF\n"
      "1:\n\t"
      :
      : [kept] "i"(&kept), [first] "n"(RAMSTART >> 8), [behind] "n"((RAMEND + 1) >> 8), [guard] "n"(int{guard_byte}),
        [guards] "n"(int{guard_size}), [passed] "n"(int{all_passed}), [ram_failed] "n"(int{ram_failed}),
        [flash_failed] "n"(int{flash_failed}), [seed] "n"(crc_at_start & 0xFF), [right] "n"(crc_at_end),
        [checked] "n"(drivers::self_test::checked_bytes >> 8), [checked_bytes] "n"(drivers::self_test::checked_bytes),
        [result] "I"(_SFR_IO_ADDR(GPIOR2)), [latch] "I"(drivers::avr::port_c + 2), [latch_bit] "I"(6),
        [led_direction] "I"(drivers::avr::port_b + 1), [after_flash] "n"(149), [after_ram] "n"(146),
        [change] "n"(_BV(WDCE) | _BV(WDE)), [watchdog] "n"(_SFR_MEM_ADDR(WDTCSR)), [led] "I"(drivers::avr::port_b + 2),
        [led_bit] "I"(1));
}
static_assert(drivers::avr::PowerLatch::mask == 1 << 6 && drivers::avr::StatusLed::mask == 1 << 1, "as above");
static_assert(RAMSTART % 256 == 0 && (RAMEND + 1) % 256 == 0, "the test counts pages");
static_assert(drivers::self_test::checked_bytes % 256 == 0 && crc_at_start == 0xFFFF, "so does that of the flash");
static_assert(drivers::retained::Bytes::size() == 4, "r2 to r5");

namespace drivers {
namespace retained {

Bytes read() {
  return kept;
}

void write(const Bytes& bytes) {
  kept = bytes;
}

}  // namespace retained

namespace self_test {

namespace {

// Two bytes at a time: counting them costs.
uint16_t checksum(uint16_t crc, const uint8_t* at, uint16_t count) {
  const uint8_t* const end = at + count;
  do {
    crc = _crc_ccitt_update(crc, base::next_flash_byte(at));
    crc = _crc_ccitt_update(crc, base::next_flash_byte(at));
  } while (at != end);
  return crc;
}
static_assert(bytes_of_a_step % 2 == 0, "two at a time");

void begin_round() {
  next_byte = nullptr;  // the flash begins at 0
  round_crc = crc_at_start;
}

}  // namespace

void start() {
  begin_round();
}

Result result() {
  switch (GPIOR2) {
    case all_passed:
      return Result::passed;
    case flash_failed:
      return Result::flash;
    case flash_failed_later:
      return Result::flash_later;
    default:
      return Result::ram;
  }
}

void step() {
  round_crc = checksum(round_crc, next_byte, bytes_of_a_step);
  next_byte += bytes_of_a_step;
  if (next_byte != reinterpret_cast<const uint8_t*>(checked_bytes)) {
    return;
  }
  if (round_crc != crc_at_end && GPIOR2 == all_passed) {
    GPIOR2 = flash_failed_later;
  }
  begin_round();
}

bool is_stack_intact() {
  for (uint8_t i = 0; i < guard_looked_at; ++i) {
    if (_end[i] != guard_byte) {
      return false;
    }
  }
  return true;
}

}  // namespace self_test
}  // namespace drivers
