#include "simulation/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/report/decode.hpp"

namespace simulation::report {
namespace {

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("  {:<22} {}\n", name, value);
}

std::string tell_delays(std::vector<Time> delays) {
  if (delays.empty()) {
    return "no answer";
  }
  std::sort(delays.begin(), delays.end());
  const auto microseconds = [](Time time) { return milliseconds(time) * 1000; };
  return fmt::format("{:.1f} us least, {:.1f} us median, {:.1f} us most ({} answers)", microseconds(delays.front()),
                     microseconds(delays[delays.size() / 2]), microseconds(delays.back()), delays.size());
}

std::string tell_stop(const Stop& stop) {
  return fmt::format("from {:.2f} m/s: slowing after {:.1f} ms, still after {:.2f} s and {:.0f} cm, {}", stop.speed,
                     milliseconds(stop.slowing_after), seconds(stop.still_after), stop.distance * 100,
                     stop.braked_after ? fmt::format("braked after {:.2f} s", seconds(*stop.braked_after))
                                       : std::string("not braked"));
}

std::string tell_states(const std::set<int>& states) {
  std::vector<std::string> words;
  for (const int state : states) {
    words.push_back(fmt::format("{:02X} {}", state, system_state_name(state)));
  }
  return words.empty() ? "none reported" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string make_table(const Story& story, const Transcript& transcript, World& world) {
  const BoardStatistics statistics = world.board().statistics();
  std::string text;
  text += row("simulated", fmt::format("{:.3f} s on {}", seconds(world.now()), world.board().name()));
  text += row("bus", fmt::format("{} cycles, {} bytes, transcript {:016x}", transcript.cycles().size() - 1,
                                 transcript.byte_count(), transcript.hash()));
  text += row("answer delay", tell_delays(story.answer_delays()));
  text += row("top speed", fmt::format("{:.2f} m/s", story.top_speed()));
  for (const Stop& stop : story.stops()) {
    text += row("stop", fmt::format("{} at {:.3f} s, {}", stop.cause, seconds(stop.at), tell_stop(stop)));
  }
  text += row("system states", tell_states(story.system_states()));
  text += row("resets, lost bytes", fmt::format("{}, {}", statistics.resets, statistics.overruns));
  if (statistics.cycles > 0) {
    const auto awake = statistics.cycles - statistics.cycles_asleep;
    text += row("CPU load",
                fmt::format("{:.1f} %", 100.0 * static_cast<double>(awake) / static_cast<double>(statistics.cycles)));
  }
  text += row("complaints",
              statistics.complaints.empty() ? "none" : fmt::format("{}", fmt::join(statistics.complaints, "; ")));
  return text;
}

}  // namespace simulation::report
