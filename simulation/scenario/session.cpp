#include "simulation/scenario/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "simulation/board/avr_board.hpp"
#include "simulation/board/host_board.hpp"
#include "simulation/eeprom/events.hpp"
#include "simulation/monitor/monitor.hpp"
#include "simulation/report/inside_log.hpp"
#include "simulation/report/story.hpp"
#include "simulation/report/table.hpp"
#include "simulation/scenario/record.hpp"
#include "simulation/scenario/runner.hpp"

namespace simulation::scenario {
namespace {

constexpr std::uint64_t default_seed = 1;
constexpr std::size_t cycles_in_report = 4;

std::unique_ptr<SpmBoard> make_board(const Request& request) {
  if (request.board == "host") {
    return make_host_board();
  }
  AvrBoardOptions options;
  options.image = request.image;
  return make_avr_board(options);
}

bool can_judge(const Scenario& scenario, const std::string& board) {
  return scenario.needs.empty() ||
         std::find(scenario.needs.begin(), scenario.needs.end(), board) != scenario.needs.end();
}

std::string tell_bus_and_command(const Scenario& scenario, const Request& request,
                                 const report::Transcript& transcript) {
  return fmt::format("  the bus at last\n{}  again     pilotfish run {} --on {} --log{}\n",
                     report::tell_last_cycles(transcript, cycles_in_report), scenario.file, request.board,
                     request.seed ? fmt::format(" --seed {}", *request.seed) : "");
}

std::string tell_failure(const Scenario& scenario, const Request& request, const Failure& failure,
                         const report::Transcript& transcript) {
  std::string text =
      fmt::format("{}: expectation not met at {:.3f} s on {}\n", show(scenario.file, {failure.mark, scenario.name}),
                  seconds(failure.at), request.board);
  text += fmt::format("  expected  {}\n  seen      {}\n", failure.expected, failure.seen);
  text += fmt::format("  clauses   {}\n", fmt::join(scenario.spec, ", "));
  return text + tell_bus_and_command(scenario, request, transcript);
}

std::string tell_breach(const Scenario& scenario, const Request& request, const monitor::Breach& breach,
                        const report::Transcript& transcript) {
  const monitor::Clause& clause = *breach.clause;
  std::string text = fmt::format("{}: {}: the monitor saw {} broken at {:.4f} s on {}\n", scenario.file, scenario.name,
                                 clause.id, seconds(breach.at), request.board);
  text += fmt::format("  clause    {} ({})\n  judged    {}\n  seen      {}\n", clause.says, clause.stands_for,
                      clause.tolerance, breach.seen);
  return text + tell_bus_and_command(scenario, request, transcript);
}

std::string tell_complaints(const std::vector<std::string>& complaints) {
  return fmt::format("the board complains:\n  {}\n", fmt::join(complaints, "\n  "));
}

// Everybody who watches one run, wired up in the order in which they must be told.
struct Watchers {
  Watchers(const Scenario& scenario, const Request& request, World& world, report::Transcript& transcript,
           std::ostream& out)
      : facts(world),
        log(page),
        inside(world, page, log),
        story(facts, page, log),
        monitor(scenario.exceptions.clauses) {
    world.observe(transcript);
    world.observe(monitor);
    world.observe(facts);
    // Words cost time: they are made only for somebody who reads them.
    if (request.wants_log || request.folder) {
      world.observe(log);
      world.observe(inside);
    }
    if (request.wants_story || request.wants_log || request.folder) {
      world.observe(story);
    }
    if (request.wants_story || request.wants_log) {
      page.add_reader(out, request.palette, request.wants_log);
    }
    if (request.folder) {
      record = std::make_unique<Record>(scenario, facts, page, world);
    }
  }

  void finish() {
    log.finish();
    page.finish();
  }

  report::Facts facts;
  report::Page page;
  report::BusLog log;
  report::InsideLog inside;
  report::Story story;
  monitor::Monitor monitor;
  std::unique_ptr<Record> record;
};

void judge(const Scenario& scenario, const Request& request, const std::optional<Failure>& failure,
           const std::vector<monitor::Breach>& breaches, World& world, Result& result) {
  const auto complaints = world.board().statistics().complaints;
  if (!complaints.empty()) {
    result.verdict = Verdict::broken;
    result.report = tell_complaints(complaints);
  }
  if (complaints.empty()) {
    result.verdict = failure || !breaches.empty() ? Verdict::failed : Verdict::passed;
  }
  if (!breaches.empty()) {
    result.report += tell_breach(scenario, request, breaches.front(), result.transcript);
  }
  if (failure) {
    result.report += tell_failure(scenario, request, *failure, result.transcript);
  }
}

void fit(World& world, const Module& module) {
  world.fit_lighting(module.has_lighting);
  world.fit_power_module(module.is_there);
  if (!module.eeprom.empty()) {
    world.board().set_eeprom(module.eeprom);
  }
}

void play_into(Result& result, const Scenario& scenario, const Request& request, std::ostream& out) {
  World world(make_board(request), request.seed.value_or(scenario.seed.value_or(default_seed)));
  fit(world, scenario.module);
  Watchers watchers(scenario, request, world, result.transcript, out);
  Runner runner(scenario, world, watchers.facts, watchers.story);
  runner.stop_when([&] { return !watchers.monitor.breaches().empty(); });
  const auto failure = runner.run();
  watchers.finish();
  result.simulated = world.now();
  result.eeprom = world.board().eeprom();
  if (request.wants_log) {
    out << "\nEvent log in the EEPROM\n" << eeprom::make_event_table(result.eeprom);
  }
  if (request.wants_story) {
    out << '\n' << report::make_table(watchers.story, result.transcript, world);
  }
  if (watchers.record) {
    watchers.record->write(*request.folder, watchers.story, result.files, result.remarks);
  }
  judge(scenario, request, failure, watchers.monitor.breaches(), world, result);
}

}  // namespace

Result play(const Scenario& scenario, const Request& request, std::ostream& out) {
  Result result;
  if (!can_judge(scenario, request.board)) {
    result.verdict = Verdict::skipped;
    result.report = fmt::format("needs {}", fmt::join(scenario.needs, " or "));
    return result;
  }
  try {
    play_into(result, scenario, request, out);
  } catch (const std::exception& error) {
    result.verdict = Verdict::broken;
    result.report = fmt::format("{}: simulation error on {}: {}\n", scenario.file, request.board, error.what());
  }
  return result;
}

}  // namespace simulation::scenario
