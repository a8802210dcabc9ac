// Reads answers, pauses, turns and cycles off the bus. A cycle begins with the remote's turn.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulation/bench/figures.hpp"
#include "simulation/world.hpp"

namespace simulation::bench {

struct Turn {
  Time from{};
  Time until{};  // end of its last stop bit
  int bytes = 0;
  bool has_ended = false;  // by TF
};

struct Cycle {
  Turn sr;
  Turn spm;
  Turn sacu;

  Time busy() const { return length(sr) + length(spm) + length(sacu); }
  Time last_end() const { return std::max({sr.until, spm.until, sacu.until}); }

  static Time length(const Turn& turn) { return turn.until - turn.from; }
};

class BusMeter : public Observer {
 public:
  void on_byte(const BusByte& byte) override;

  // Forgets what was before; the cycle that begins next is the first one measured.
  void begin();
  // Writes what it has seen of the bus.
  void tell(RunFigures& figures) const;
  // The median of the cycles with these turns since the first byte; nothing if there was none.
  std::optional<double> busy_us(int sr_bytes, int spm_bytes, int sacu_bytes) const;

 private:
  void begin_cycle(const BusByte& byte);
  void close_cycle(Time next);
  void extend(Turn& turn, const BusByte& byte);

  Cycle cycle_;
  bool has_begun_ = false;  // a cycle
  Sender last_sender_ = Sender::noise;
  Time last_end_{};
  bool is_disturbed_ = false;  // this cycle, by whoever spoke out of turn

  std::vector<Cycle> history_;  // of all cycles
  Readings answer_;
  Readings pause_;
  std::array<Readings, 3> lengths_;
  std::array<Readings, 3> bytes_;
  Readings end_of_talk_;
  Readings utilisation_;
  std::uint64_t cycles_ = 0;
  std::uint64_t broken_ = 0;
  std::uint64_t broken_by_sacu_ = 0;
  std::uint64_t spoiled_ = 0;
};

}  // namespace simulation::bench
