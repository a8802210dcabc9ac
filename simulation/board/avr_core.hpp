// The CPU in simavr: image, run loop, sleep, resets. The peripherals' mends are parts of their own, built on this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulation/board/avr_clock.hpp"
#include "simulation/board/avr_image.hpp"
#include "simulation/board/avr_interrupts.hpp"
#include "simulation/board/avr_lock_watch.hpp"
#include "simulation/board/avr_simavr.hpp"
#include "simulation/board/spm_board.hpp"

namespace simulation {

class AvrCore {
 public:
  // Throws std::runtime_error for an unknown chip or an image that does not fit.
  AvrCore(const std::string& mcu, std::uint32_t frequency, const AvrImage& image);
  ~AvrCore();
  AvrCore(const AvrCore&) = delete;
  AvrCore& operator=(const AvrCore&) = delete;

  avr_t& avr() { return *avr_; }
  const avr_t& avr() const { return *avr_; }
  AvrInterrupts& interrupts() { return *interrupts_; }
  const AvrInterrupts& interrupts() const { return *interrupts_; }

  Cycle now() const { return avr_->cycle; }

  // Runs up to `target`, an instruction further at most; or until just after stop().
  void run(Cycle target);
  void stop();

  // Power-on fills RAM and the CPU's registers with garbage first.
  void reset(ResetKind kind);
  // `again` runs at the end of every reset, the watchdog's included: the place to re-arm timers and levels.
  void on_reset(std::function<void()> again) { reset_calls_.push_back(std::move(again)); }

  // A register with all that its write does, or a byte of RAM.
  void write(std::uint16_t address, std::uint8_t value);
  // In the program, wherever an instruction of one word is `from`; how often that was.
  int replace(std::uint16_t from, std::uint16_t to);
  // Flips a bit of the program; sticks one of RAM from now on, which costs half the speed.
  void flip_flash(std::uint32_t address, int bit);
  void stick_ram(std::uint32_t address, int bit, bool is_high);

  // Watches how long interrupts are off, from now on; call before the first reset. Costs half the speed.
  void watch_locks();
  const AvrLockWatch* lock_watch() const { return lock_watch_.get(); }

  void complain(const std::string& text);
  BoardStatistics& statistics() { return statistics_; }
  const BoardStatistics& statistics() const { return statistics_; }

  // The byte that power-on left at a RAM address.
  static std::uint8_t garbage(std::uint16_t address);

 private:
  struct ResetHook : avr_io_t {
    AvrCore* core;
  };

  struct StuckBit {
    std::uint32_t address;
    std::uint8_t mask;
    bool is_high;
  };

  void force_stuck_bits();
  bool must_single_step() const { return lock_watch_ != nullptr || !stuck_bits_.empty(); }

  void step(Cycle target);
  void sleep_on(Cycle target);
  void stay_frozen(Cycle target);
  void run_instructions();
  void fall_asleep();
  void check_sanity();
  void after_reset();
  avr_cycle_count_t reach_target(avr_cycle_count_t) { return 0; }

  avr_t* avr_ = nullptr;
  std::unique_ptr<AvrInterrupts> interrupts_;
  std::unique_ptr<AvrLockWatch> lock_watch_;
  ResetHook reset_hook_{};
  std::vector<std::function<void()>> reset_calls_;
  std::vector<StuckBit> stuck_bits_;
  BoardStatistics statistics_;
  std::size_t code_size_;
  bool is_stopping_ = false;
  bool was_asleep_ = false;
  bool has_strayed_ = false;
};

}  // namespace simulation
