#include "simulation/bench/targets.hpp"

#include <fmt/format.h>

namespace simulation::bench {
namespace {

constexpr double cycles_in_a_us = 8;
constexpr double latest_answer_us = 50;
constexpr double longest_pause_us = 1;
constexpr double longest_interrupt_us = 40;
constexpr double longest_lock_us = 20;
constexpr double highest_load = 0.40;
constexpr double highest_load_in_noise = 0.60;  // 3491 characters a second, which no remote sends (H-23)
constexpr double latest_answer_in_noise_us = 100;
constexpr double latest_stop_ms = 63;     // SB-2.15, and a sample
constexpr double longest_stop_ms = 1500;  // SB-2.17

void judge(const RunFigures& run, std::vector<Target>& all) {
  const auto add = [&](const std::string& what, const std::string& wanted, const std::string& seen, bool is_met) {
    all.push_back({fmt::format("{}, {} traffic", what, run.name), wanted, seen, is_met});
  };
  add("answer", fmt::format("0 to {:.0f} us", latest_answer_us),
      fmt::format("{:.1f} to {:.1f} us", run.answer.least, run.answer.most),
      run.answer.count > 0 && run.answer.least >= 0 && run.answer.most <= latest_answer_us);
  add("idle time inside the turn", fmt::format("at most {:.0f} us", longest_pause_us),
      fmt::format("{:.1f} us", run.pause.most), run.pause.count > 0 && run.pause.most <= longest_pause_us);
  add("turns that lie in their cycle", "all", fmt::format("{} of {}", run.cycles - run.broken_cycles, run.cycles),
      run.cycles > 0 && run.broken_cycles == 0);
  for (const InterruptFigures& interrupt : run.interrupts) {
    const double longest = static_cast<double>(interrupt.longest_cycles) / cycles_in_a_us;
    add("longest " + interrupt.name, fmt::format("under {:.0f} us", longest_interrupt_us),
        fmt::format("{:.1f} us", longest), longest < longest_interrupt_us);
  }
  const double locked = static_cast<double>(run.locked.cycles) / cycles_in_a_us;
  add("interrupts off", fmt::format("at most {:.0f} us", longest_lock_us),
      fmt::format("{:.1f} us from {}", locked, run.locked.place), locked <= longest_lock_us);
  add("CPU load", fmt::format("under {:.0f} %", highest_load * 100), fmt::format("{:.1f} %", run.load * 100),
      run.load < highest_load);
  const Losses& losses = run.losses;
  add("lost bytes", "none",
      fmt::format("{} overruns, {} spoiled, {} turns unanswered, {} packets corrupt, {} characters not returned",
                  losses.overruns, losses.spoiled, losses.missed, losses.corrupt, losses.unreturned),
      losses.sum() == 0);
  add("complaints of the chip", "none", run.complaints.empty() ? "none" : run.complaints.front(),
      run.complaints.empty());
}

void judge(const NoiseFigures& run, std::vector<Target>& all) {
  const auto add = [&](const std::string& what, const std::string& wanted, const std::string& seen, bool is_met) {
    all.push_back({fmt::format("{}, noise {}", what, run.name), wanted, seen, is_met});
  };
  add("CPU load", fmt::format("under {:.0f} %", highest_load_in_noise * 100), fmt::format("{:.1f} %", run.load * 100),
      run.load < highest_load_in_noise);
  const double expected = run.seconds * 1000;
  const double ticks = static_cast<double>(run.ticks);
  add("milliseconds counted", fmt::format("{:.0f}, give or take one", expected), fmt::format("{:.0f}", ticks),
      ticks >= expected - 1 && ticks <= expected + 1);
  add("emergency stop begins", fmt::format("within {:.0f} ms of the last general", latest_stop_ms),
      run.stop_begins_ms ? fmt::format("{:.1f} ms", *run.stop_begins_ms) : "it did not",
      run.stop_begins_ms && *run.stop_begins_ms <= latest_stop_ms);
  add("emergency stop ends", fmt::format("within {:.0f} ms, no duty grows", longest_stop_ms),
      run.stop_lasts_ms ? fmt::format("{:.0f} ms{}", *run.stop_lasts_ms, run.grew ? ", a duty grew" : "")
                        : "it did not",
      run.stop_lasts_ms && *run.stop_lasts_ms <= longest_stop_ms && !run.grew);
  if (run.hears_remote) {
    const auto turns = static_cast<std::size_t>(run.seconds * 50);
    add("answer", fmt::format("0 to {:.0f} us, every turn", latest_answer_in_noise_us),
        fmt::format("{:.1f} to {:.1f} us, {} of {}", run.answer.least, run.answer.most, run.answer.count, turns),
        run.answer.least >= 0 && run.answer.most <= latest_answer_in_noise_us && run.answer.count + 1 >= turns);
  } else {
    add("said into the noise", "nothing", fmt::format("{} characters", run.characters_said), run.characters_said == 0);
  }
  add("lost in the UART", "none", fmt::format("{}", run.overruns), run.overruns == 0);
  add("turns answered afterwards", "all", run.is_back ? "all" : "not all", run.is_back);
}

}  // namespace

std::vector<Target> targets(const Figures& figures) {
  std::vector<Target> all;
  judge(figures.idle, all);
  judge(figures.heavy, all);
  for (const NoiseFigures& noise : figures.noise) {
    judge(noise, all);
  }
  for (const RunFigures* run : {&figures.idle, &figures.heavy}) {
    if (figures.image.stack_bound && run->stack_used) {
      all.push_back({fmt::format("stack, {} traffic", run->name),
                     fmt::format("at most the proven {} bytes", *figures.image.stack_bound),
                     fmt::format("{} bytes", *run->stack_used), *run->stack_used <= *figures.image.stack_bound});
    }
  }
  return all;
}

}  // namespace simulation::bench
