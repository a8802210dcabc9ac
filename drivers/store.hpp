// Bytes that survive power loss: the EEPROM. Writing a byte takes 3.4 ms; nothing here waits for it.
#pragma once

#include <stdint.h>

namespace drivers {
namespace store {

constexpr uint16_t size = 4096;

// True while a write is going on: then neither read() nor write() may be called.
bool is_busy();
uint8_t read(uint16_t address);
// Starts a write; a byte that already holds the value is not written again.
void write(uint16_t address, uint8_t value);

}  // namespace store
}  // namespace drivers
