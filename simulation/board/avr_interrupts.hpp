// Interrupts as silicon has them, on top of simavr's: response time, sources that keep asking, clean withdrawal.
// Also counts what each one costs.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simulation/board/avr_clock.hpp"
#include "simulation/board/avr_interrupt_use.hpp"
#include "simulation/board/avr_lock_watch.hpp"
#include "simulation/board/avr_simavr.hpp"

namespace simulation {

class AvrInterrupts {
 public:
  explicit AvrInterrupts(avr_t& avr);
  AvrInterrupts(const AvrInterrupts&) = delete;
  AvrInterrupts& operator=(const AvrInterrupts&) = delete;

  // Sets the flag, and asks for service if enabled.
  void raise(avr_int_vector_t& vector) { avr_raise_interrupt(&avr_, &vector); }

  // Stops asking; the flag stays.
  void withdraw(avr_int_vector_t& vector);

  bool is_enabled(const avr_int_vector_t& vector) const;

  // A source without a memory: it asks whenever `asks` holds, again right after each service.
  // Call update() when the answer may have changed.
  void make_level(avr_int_vector_t& vector, std::function<bool()> asks);
  void update(avr_int_vector_t& vector);

  // The most urgent of what is pending, if interrupts are on.
  void serve();
  // The same by a CPU that leaves sleep for it.
  void serve_after_sleep();

  std::vector<InterruptUse> uses() const;
  // Tells `watch` of every service from now on.
  void tell(AvrLockWatch& watch) { watch_ = &watch; }

 private:
  struct Watched {
    AvrInterrupts* owner;
    avr_int_vector_t* vector;
    std::function<bool()> asks;
    InterruptUse use;
    Cycle entered = 0;

    void on_running(std::uint32_t value);
  };

  Watched* watched(const avr_int_vector_t& vector);
  void begin(Watched& source);
  void end(Watched& source);
  void update(Watched& source);

  avr_t& avr_;
  std::vector<std::unique_ptr<Watched>> sources_;
  Cycle wake_up_cycles_ = 0;
  AvrLockWatch* watch_ = nullptr;
};

}  // namespace simulation
