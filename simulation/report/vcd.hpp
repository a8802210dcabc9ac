// A waveform file with one-bit signals only, which GTKWave, PulseView and sigrok-cli all read. The bus line
// is drawn from the characters with their true bit edges.
#pragma once

#include <iosfwd>
#include <vector>

#include "simulation/world.hpp"

namespace simulation::report {

class Waveform : public Observer {
 public:
  Waveform();

  void on_byte(const BusByte& byte) override;
  void on_wake(bool asserted, Time at) override;
  void on_power(bool powered, Time at) override;
  void on_sample(const Sample& sample) override;

  // Timescale 100 ns: a bit of 26.04 us keeps its length to 0.4 %.
  void write(std::ostream& out) const;

 private:
  struct Change {
    Time at{};
    std::size_t signal = 0;
    bool level = false;
  };
  struct Dominant {
    Time from{};
    Time to{};
  };

  void set(std::size_t signal, bool level, Time at);
  std::vector<Change> bus_changes() const;

  std::vector<Change> changes_;
  std::vector<bool> levels_;
  std::vector<Dominant> dominant_;  // when some node pulls the line to 0
  Time end_{};
};

}  // namespace simulation::report
