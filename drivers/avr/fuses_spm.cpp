// The SPM's fuses: part of the image, so they are written down once. A bit that is named is programmed (0).
#include <avr/io.h>

// low       full-swing crystal (CKSEL 0111), long start-up for a slowly rising supply, no division by 8
// high      SPI programming on, JTAG off (its pins are lamps), EEPROM kept over a chip erase, watchdog by software
// extended  brown-out reset at 4.3 V; the unused bits read as ones
FUSES = {FUSE_CKSEL3, FUSE_SPIEN& FUSE_EESAVE, FUSE_BODLEVEL1& FUSE_BODLEVEL0};
