// Everything around one power module, in simulated time: wire, remote, attendant control, chair, supply. A scenario
// talks to this and to nothing below it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/bus_event.hpp"
#include "simulation/models/chair.hpp"
#include "simulation/models/remote.hpp"
#include "simulation/models/sacu.hpp"
#include "simulation/time.hpp"
#include "simulation/wire.hpp"

namespace simulation {

// One line of the story in numbers, taken every millisecond.
struct Sample {
  Time at{};
  Pins pins;
  bool spm_powered = false;
  std::uint32_t resets = 0;  // of the chip, since power on
  RemoteControls controls;
  ChairState chair;
};

// Who wants to know. All are called in order of time.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void on_byte(const BusByte&) {}
  virtual void on_wake(bool /*asserted*/, Time) {}
  virtual void on_power(bool /*powered*/, Time) {}
  virtual void on_sample(const Sample&) {}
};

class World {
 public:
  explicit World(std::unique_ptr<SpmBoard> board, std::uint64_t seed = 1);
  ~World();

  Time now() const;
  void run_for(Time span);
  void run_until(Time limit);
  void observe(Observer& observer);  // must outlive the world's last run

  SpmBoard& board();
  Wire& wire();
  Remote& remote();
  Sacu& sacu();  // not attached at first
  Chair& chair();

  // Plugs the attendant control in, at the power module's end of the cable, or unplugs it.
  void attach_sacu();
  void detach_sacu();

  // Bytes back to back from now on, in somebody's name: whose name it is, that module does not answer them.
  void say_as(Sender sender, const std::vector<std::uint8_t>& values);

  // The power module's input from seat or lift.
  void ask_for_slow(bool is_asked);
  // Before anything runs: the strap of the board, and whether there is a power module at all.
  void fit_lighting(bool is_fitted);
  void fit_power_module(bool is_fitted);

  bool spm_powered() const;
  const Sample& latest() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace simulation
