// How much of the time the CPU is awake, cycle of the bus by cycle of the bus.
#pragma once

#include "simulation/bench/spread.hpp"
#include "simulation/board/avr_board.hpp"
#include "simulation/world.hpp"

namespace simulation::bench {

class LoadMeter : public Observer {
 public:
  explicit LoadMeter(const AvrBoard& board) : board_(board) {}

  void on_sample(const Sample&) override {
    if (++samples_ % samples_in_a_cycle != 0) {
      return;
    }
    const BoardStatistics now = board_.statistics();
    loads_.add(share(now, latest_));
    latest_ = now;
  }

  void begin() {
    loads_.clear();
    first_ = latest_ = board_.statistics();
  }
  double load() const { return share(board_.statistics(), first_); }
  Spread per_cycle() const { return loads_.spread(); }

 private:
  static constexpr unsigned samples_in_a_cycle = 20;

  static double share(const BoardStatistics& now, const BoardStatistics& before) {
    const double cycles = static_cast<double>(now.cycles - before.cycles);
    const double asleep = static_cast<double>(now.cycles_asleep - before.cycles_asleep);
    return cycles > 0 ? 1 - asleep / cycles : 0;
  }

  const AvrBoard& board_;
  BoardStatistics first_;
  BoardStatistics latest_;
  Readings loads_;
  unsigned samples_ = 0;
};

}  // namespace simulation::bench
