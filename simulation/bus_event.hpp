// What happened on the bus, character by character: the one stream that logs, transcripts, captures and
// waveforms are made from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "simulation/time.hpp"

namespace simulation {

// The tester is what stands in a factory: it speaks to remote and attendant control (SB-07.1).
enum class Sender : std::uint8_t { sr, spm, sacu, noise, tester };
constexpr std::size_t sender_count = 5;

struct BusByte {
  Time start{};  // falling edge of the start bit
  Time end{};    // end of the last stop bit
  Sender sender = Sender::noise;
  std::uint8_t sent = 0;   // as the sender meant it
  std::uint8_t heard = 0;  // as a nominal receiver reads the line
  bool spoiled = false;    // framing error at a nominal receiver
  bool lost = false;       // never reached the line (cable cut, dropped by a fault, wake asserted)
};

}  // namespace simulation
