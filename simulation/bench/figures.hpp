// What one bench tells, as plain values. Times are microseconds at the pin, shares are 0 to 1, cycles are the CPU's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/bench/spread.hpp"
#include "simulation/board/avr_interrupt_use.hpp"

namespace simulation::bench {

struct TurnFigures {
  Spread length;  // first start bit to last stop bit
  Spread bytes;
};

struct InterruptFigures {
  std::string name;
  std::uint64_t count = 0;  // in the measured time
  double per_second = 0;
  double mean_cycles = 0;
  std::uint64_t longest_cycles = 0;  // since power-on
};

struct PlacedSpan {
  std::uint64_t cycles = 0;
  std::string place;
};

struct Losses {
  std::uint64_t overruns = 0;    // characters lost in the UART
  std::uint64_t spoiled = 0;     // characters that a nominal receiver could not read, or that never reached the line
  std::uint64_t missed = 0;      // turns of the remote without an answer
  std::uint64_t corrupt = 0;     // packets that remote or attendant control found corrupt
  std::uint64_t unreturned = 0;  // of the programmer's characters, those that did not come back in their place

  std::uint64_t sum() const { return overruns + spoiled + missed + corrupt + unreturned; }
};

// One kind of traffic.
struct RunFigures {
  std::string name;
  bool has_sacu = false;
  double seconds = 0;  // measured
  Spread answer;       // end of the remote's TF to the power module's first start bit
  Spread pause;        // inside the power module's turn: from a byte's last stop bit to the next start bit
  TurnFigures sr;
  TurnFigures spm;
  TurnFigures sacu;
  Spread end_of_talk;  // of the last turn, since the cycle began
  std::uint64_t cycles = 0;
  std::uint64_t broken_cycles = 0;  // a turn was missing, without TF, overlapped, or ran into the next cycle
  Spread utilisation;               // share of each cycle that turns take
  double load = 0;                  // share of time that the CPU was awake
  Spread load_per_cycle;
  std::vector<InterruptFigures> interrupts;
  PlacedSpan locked;  // interrupts off outside of any handler
  PlacedSpan off;     // the same, handlers included
  PlacedSpan off_at_start;
  Losses losses;
  std::uint64_t characters = 0;             // from and to the programmer
  std::optional<std::uint64_t> stack_used;  // bytes
  std::vector<std::string> complaints;      // of the simulated chip
};

// The document's examples of how full the bus is, with the byte counts of its own tables (SB-5.5).
struct Example {
  std::string name;
  int sr_bytes = 0;
  int spm_bytes = 0;
  int sacu_bytes = 0;
  double computed_us = 0;               // with the document's 50 us between bytes
  double back_to_back_us = 0;           // without
  std::optional<double> measured_us{};  // median; nothing if it did not occur
};

// Somebody babbles: random characters back to back, for a share of the time or between the turns, from the moment on at
// which the chair drives (H-23).
struct NoiseFigures {
  std::string name;
  bool hears_remote = false;  // the noise leaves its turns alone
  double seconds = 0;         // of noise
  double load = 0;
  Spread load_per_cycle;
  std::uint64_t ticks = 0;  // of the millisecond clock
  Spread answer;            // end of the remote's TF to the first start bit, where it was answered
  std::uint64_t characters_said = 0;
  std::optional<double> stop_begins_ms;  // after the end of the last general that was whole
  std::optional<double> stop_lasts_ms;   // until both duties are zero
  bool grew = false;                     // a duty, after the stop had begun
  std::uint64_t off = 0;                 // cycles, interrupts off, handlers included, since power-on
  std::uint64_t longest_interrupt = 0;   // cycles, since power-on
  std::uint64_t overruns = 0;
  bool is_back = false;  // half a second after the noise every turn is answered again
  std::vector<std::string> complaints;
};

struct ImageFigures {
  std::string name;  // of the file
  std::string compiler;
  std::uint64_t flash = 0;
  std::optional<std::uint64_t> static_ram;
  std::optional<std::uint64_t> stack_bound;  // proven from the machine code by tests/tools/budget
};

struct Figures {
  ImageFigures image;
  RunFigures idle;
  RunFigures heavy;
  std::vector<NoiseFigures> noise;
  std::vector<Example> examples;
};

}  // namespace simulation::bench
