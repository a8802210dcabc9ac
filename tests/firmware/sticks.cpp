// Every stick position on the chip. The EEPROM's first bytes: whether one pot is meant, which one, and the step from
// one reading of speed to the next.
#include <avr/eeprom.h>
#include <avr/io.h>

#include "spm/settings.hpp"
#include "tests/vectors/sticks.hpp"

volatile uint32_t digests[vectors::stick_blocks];
volatile uint32_t counts[vectors::stick_blocks];
volatile uint8_t current;  // the block being run; stick_blocks when all are done

static uint8_t setting(uint16_t at) {
  return eeprom_read_byte(reinterpret_cast<const uint8_t*>(at));
}

int main() {
  const vectors::StickOrder order{setting(0) != 0, setting(1), setting(2)};
  const spm::DriveProfile profile = spm::make_profile(spm::Settings());
  for (uint8_t block = 0; block < vectors::stick_blocks; ++block) {
    current = block;
    const vectors::StickDigest digest = vectors::stick_block(block, order, profile);
    digests[block] = digest.value();
    counts[block] = digest.count();
  }
  current = vectors::stick_blocks;
  for (;;) {
  }
}
