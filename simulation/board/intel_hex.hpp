// Intel HEX: what avrdude, objcopy and this project's build write.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace simulation {

// Hands out the data of each record with its address. Throws std::runtime_error that says what is wrong.
void parse_intel_hex(const std::vector<std::uint8_t>& file,
                     const std::function<void(std::size_t address, const std::uint8_t* data, std::size_t size)>& place);

}  // namespace simulation
