#include "simulation/bench/noise.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "simulation/bench/bus_meter.hpp"
#include "simulation/bench/load_meter.hpp"
#include "simulation/board/avr_board.hpp"
#include "simulation/world.hpp"

namespace simulation::bench {
namespace {

enum class Noise { all, half, gaps };

constexpr Time start_up = 1s;
constexpr Time drive = 4s;
constexpr Time recovery = 500ms;
constexpr Time period = 20ms;             // SB-2.2
constexpr Time between_cycles = 5ms;      // no sender pauses that long within a turn
constexpr Time gap_from = 7500us;         // the longest answer here is over
constexpr Time gap_length = 12ms;         // and the last character ends before the remote begins
constexpr std::uint8_t tick_vector = 16;  // TIMER0_COMPA
constexpr Time longest_unheard = 4s;      // SB-4.4
constexpr int stick = 800;

// What the bus and the pins tell of the stop, and whether anything was said into the noise.
class StopMeter : public Observer {
 public:
  void on_byte(const BusByte& byte) override {
    if (byte.sender == Sender::spm && begun_) {
      ++spoken_;
    }
    if (byte.sender != Sender::sr) {
      return;
    }
    if (byte.start - last_ > between_cycles) {
      turn_ = byte.start;
      place_ = 0;
      is_clean_ = true;
    }
    last_ = byte.start;
    is_clean_ = is_clean_ && !byte.spoiled && !byte.lost && byte.heard == byte.sent;
    if (++place_ == general_bytes && is_clean_ && !falls_) {
      general_ = byte.end;
    }
  }

  void on_sample(const Sample& sample) override {
    const int duty = sample.pins.left_duty + sample.pins.right_duty;
    if (begun_ && !falls_ && duty < duty_) {
      falls_ = sample.at;
    }
    if (falls_ && !stands_ && duty == 0) {
      stands_ = sample.at;
    }
    has_grown_ = has_grown_ || (falls_ && duty > duty_);
    duty_ = duty;
  }

  void begin(Time now) {
    begun_ = now;
    spoken_ = 0;
  }
  Time turn() const { return turn_; }
  void tell(NoiseFigures& figures) const {
    figures.characters_said = spoken_;
    figures.grew = has_grown_;
    if (falls_) {
      figures.stop_begins_ms = seconds(*falls_ - general_) * 1000;
    }
    if (stands_) {
      figures.stop_lasts_ms = seconds(*stands_ - *falls_) * 1000;
    }
  }

 private:
  static constexpr int general_bytes = 9;

  std::optional<Time> begun_;
  std::optional<Time> falls_;
  std::optional<Time> stands_;
  bool has_grown_ = false;
  int duty_ = 0;
  std::uint64_t spoken_ = 0;
  Time general_{};  // the end of the last one that was whole
  Time turn_{};     // the begin of the remote's latest
  Time last_{};
  int place_ = 0;
  bool is_clean_ = false;
};

class NoiseBench {
 public:
  NoiseBench(const std::string& image, Noise noise) : noise_(noise), world_(make_board(image)), cpu_(*board_) {
    world_.observe(bus_);
    world_.observe(cpu_);
    world_.observe(stop_);
  }
  NoiseBench(const NoiseBench&) = delete;
  NoiseBench& operator=(const NoiseBench&) = delete;

  NoiseFigures run(Time span) {
    world_.remote().start(world_.now());
    world_.run_for(start_up);
    world_.remote().controls.speed = stick;
    world_.run_for(drive);
    world_.run_until(stop_.turn() + period + gap_from);  // of the turn that begins now
    const std::uint32_t overruns = board_->statistics().overruns;
    const std::uint64_t ticks = tick_count();
    bus_.begin();
    cpu_.begin();
    stop_.begin(world_.now());
    const Time from = world_.now();
    make_noise(span);
    NoiseFigures figures;
    tell(figures, ticks);
    figures.seconds = seconds(world_.now() - from);
    figures.overruns = board_->statistics().overruns - overruns;
    world_.remote().controls.speed = RemoteControls{}.speed;
    world_.run_for(recovery);
    const std::uint32_t missed = world_.remote().statistics().missed;
    world_.run_for(recovery);
    figures.is_back = world_.remote().statistics().missed == missed;
    figures.complaints = board_->statistics().complaints;
    return figures;
  }

 private:
  std::unique_ptr<SpmBoard> make_board(const std::string& path) {
    auto board = make_avr_board_with_insight({.image = path, .watches_locks = true});
    board_ = board.get();
    return board;
  }

  void make_noise(Time span) {
    const Time end = world_.now() + span;
    if (noise_ != Noise::gaps) {
      world_.wire().babble(world_.now(), span, noise_ == Noise::half ? 0.5 : 1);
      world_.run_until(end);
      return;
    }
    while (world_.now() < end) {
      const Time next = world_.now() + period;
      world_.wire().babble(world_.now(), gap_length);
      world_.run_until(next);
    }
  }

  std::uint64_t tick_count() const {
    std::uint64_t count = 0;
    for (const InterruptUse& use : board_->interrupt_use()) {
      count += use.vector == tick_vector ? use.count : 0;
    }
    return count;
  }

  void tell(NoiseFigures& figures, std::uint64_t ticks) const {
    figures.name = noise_ == Noise::all    ? "all of the time"
                   : noise_ == Noise::half ? "half of the time"
                                           : "in the gaps";
    figures.hears_remote = noise_ == Noise::gaps;
    RunFigures bus;
    bus_.tell(bus);
    figures.answer = bus.answer;
    figures.load = cpu_.load();
    figures.load_per_cycle = cpu_.per_cycle();
    figures.ticks = tick_count() - ticks;
    figures.off = board_->interrupts_off().value_or(InterruptsOff{}).with_handlers.cycles;
    for (const InterruptUse& use : board_->interrupt_use()) {
      figures.longest_interrupt = std::max<std::uint64_t>(figures.longest_interrupt, use.longest);
    }
    stop_.tell(figures);
  }

  Noise noise_;
  AvrBoard* board_ = nullptr;  // the world's
  World world_;
  BusMeter bus_;
  LoadMeter cpu_;
  StopMeter stop_;
};

}  // namespace

std::vector<NoiseFigures> measure_noise(const std::string& image, double minutes) {
  // Whole cycles, and at least as long as a stop takes. A module that hears no remote is off after five seconds.
  const Time span = period * std::max<Time::rep>(150, static_cast<Time::rep>(minutes * 3000));
  std::vector<NoiseFigures> all;
  for (const Noise noise : {Noise::all, Noise::half, Noise::gaps}) {
    NoiseBench bench(image, noise);
    all.push_back(bench.run(noise == Noise::gaps ? span : std::min(span, longest_unheard)));
  }
  return all;
}

}  // namespace simulation::bench
