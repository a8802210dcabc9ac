#include "simulation/bench/measure.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "simulation/bench/bus_meter.hpp"
#include "simulation/bench/interrupt_names.hpp"
#include "simulation/bench/load_meter.hpp"
#include "simulation/bench/noise.hpp"
#include "simulation/bench/traffic.hpp"
#include "simulation/board/avr_board.hpp"
#include "simulation/board/avr_image.hpp"

namespace simulation::bench {
namespace {

constexpr std::uint64_t ram_end = 0x4100;  // of the ATmega1284P, one behind its last byte
constexpr std::uint64_t ram_begin = 0x100;
constexpr std::size_t bytes_of_a_vector = 4;

constexpr double byte_us = 11 * 1e6 / 38400;  // SB-2.1
constexpr double document_pause_us = 50;

// The program's own name of a place; an interrupt by the data sheet's.
std::string place_of(const AvrImage& image, const OffSpan& span) {
  const std::string vector = "__vector_";
  const std::string place = image.place_of(span.from);
  if (span.cycles == 0) {
    return "";
  }
  if (span.from % bytes_of_a_vector == 0 && span.from <= 34 * bytes_of_a_vector) {
    return "interrupt " + interrupt_name(span.from / bytes_of_a_vector);
  }
  if (place.starts_with(vector)) {
    const std::size_t end = place.find('+');
    const std::string number = place.substr(vector.size(), end == std::string::npos ? end : end - vector.size());
    return "interrupt " + interrupt_name(std::stoul(number)) + (end == std::string::npos ? "" : place.substr(end));
  }
  return place;
}

class Bench {
 public:
  Bench(const std::string& path, const AvrImage& image, Load load)
      : image_(image), load_(load), world_(make_board(path)), meter_(), cpu_(*board_), traffic_(world_, load) {
    world_.observe(meter_);
    world_.observe(cpu_);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  RunFigures run(std::uint64_t halves) {
    traffic_.start();
    begin();
    for (std::uint64_t i = 0; i < halves; ++i) {
      traffic_.go_on();
    }
    RunFigures figures;
    tell(figures);
    traffic_.drain();
    figures.losses.unreturned = traffic_.unreturned();
    figures.characters = traffic_.typed();
    figures.complaints = board_->statistics().complaints;
    return figures;
  }

  const BusMeter& meter() const { return meter_; }

 private:
  std::unique_ptr<SpmBoard> make_board(const std::string& path) {
    auto board = make_avr_board_with_insight({.image = path, .watches_locks = true});
    board_ = board.get();
    return board;
  }

  void begin() {
    meter_.begin();
    cpu_.begin();
    from_ = world_.now();
    missed_ = world_.remote().statistics().missed;
    corrupt_ = corrupt();
    overruns_ = board_->statistics().overruns;
    for (const InterruptUse& use : board_->interrupt_use()) {
      uses_[use.vector] = use;
    }
  }

  std::uint64_t corrupt() { return world_.remote().statistics().bad + world_.sacu().bad(); }

  void tell(RunFigures& figures) {
    figures.name = load_ == Load::idle ? "idle" : "heaviest";
    figures.has_sacu = load_ == Load::heavy;
    figures.seconds = seconds(world_.now() - from_);
    meter_.tell(figures);
    figures.load = cpu_.load();
    figures.load_per_cycle = cpu_.per_cycle();
    tell_interrupts(figures);
    figures.losses.overruns = board_->statistics().overruns - overruns_;
    figures.losses.missed = world_.remote().statistics().missed - missed_;
    figures.losses.corrupt = corrupt() - corrupt_;
    if (const auto low_water = board_->stack_low_water()) {
      figures.stack_used = ram_end - *low_water;
    }
  }

  void tell_interrupts(RunFigures& figures) {
    for (const InterruptUse& use : board_->interrupt_use()) {
      const InterruptUse before = uses_[use.vector];
      InterruptFigures row;
      row.name = interrupt_name(use.vector);
      row.count = use.count - before.count;
      row.per_second = static_cast<double>(row.count) / figures.seconds;
      row.mean_cycles =
          row.count > 0 ? static_cast<double>(use.cycles - before.cycles) / static_cast<double>(row.count) : 0;
      row.longest_cycles = use.longest;
      figures.interrupts.push_back(row);
    }
    const InterruptsOff off = board_->interrupts_off().value_or(InterruptsOff{});
    figures.locked = {off.by_program.cycles, place_of(image_, off.by_program)};
    figures.off = {off.with_handlers.cycles, place_of(image_, off.with_handlers)};
    figures.off_at_start = {off.at_start.cycles, place_of(image_, off.at_start)};
  }

  const AvrImage& image_;
  Load load_;
  AvrBoard* board_ = nullptr;  // the world's
  World world_;
  BusMeter meter_;
  LoadMeter cpu_;
  Traffic traffic_;

  Time from_{};
  std::uint64_t missed_ = 0;
  std::uint64_t corrupt_ = 0;
  std::uint64_t overruns_ = 0;
  std::map<std::uint8_t, InterruptUse> uses_;
};

Example example(const std::string& name, int sr, int spm, int sacu, const BusMeter& meter) {
  const int bytes = sr + spm + sacu;
  return {name, sr, spm, sacu, bytes * (byte_us + document_pause_us), bytes * byte_us, meter.busy_us(sr, spm, sacu)};
}

// 64-bit FNV-1a of a whole file, as tests/tools/budget notes it.
std::string fingerprint(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (char byte; stream.get(byte);) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  return std::to_string(hash);
}

// What tests/tools/budget has proven of this very image and left beside it.
void read_budget(const std::string& path, ImageFigures& figures) {
  std::ifstream stream(std::filesystem::path(path).parent_path() / "budget.json");
  if (!stream) {
    return;
  }
  const auto budget = nlohmann::json::parse(stream, nullptr, false);
  if (budget.is_object() && budget.value("image", "") == fingerprint(path) && budget.contains("stack")) {
    figures.stack_bound = budget["stack"].get<std::uint64_t>();
  }
}

ImageFigures tell_image(const std::string& path, const AvrImage& image) {
  ImageFigures figures;
  figures.name = std::filesystem::path(path).filename().string();
  figures.compiler = image.compiler;
  figures.flash = image.flash.size();
  if (const auto end = image.address_of("_end")) {
    figures.static_ram = *end - ram_begin;
  }
  read_budget(path, figures);
  return figures;
}

}  // namespace

Figures measure(const std::string& path, double minutes) {
  const AvrImage image = load_avr_image(path);
  const auto halves = static_cast<std::uint64_t>(std::max(1.0, std::round(minutes * 120)));
  Figures figures;
  figures.image = tell_image(path, image);
  Bench idle(path, image, Load::idle);
  figures.idle = idle.run(halves);
  Bench heavy(path, image, Load::heavy);
  figures.heavy = heavy.run(halves);
  figures.noise = measure_noise(path, minutes / 3);
  figures.examples = {example("power-up with an attendant control", 11, 4, 10, heavy.meter()),
                      example("normal, no programmer", 10, 10, 0, idle.meter()),
                      example("programmer both ways, calibration, attendant control", 23, 20, 9, heavy.meter())};
  return figures;
}

}  // namespace simulation::bench
