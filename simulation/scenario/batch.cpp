#include "simulation/scenario/batch.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "simulation/scenario/parse.hpp"
#include "simulation/scenario/session.hpp"

namespace simulation::scenario {
namespace {

enum ExitCode { all_passed = 0, some_failed = 1, bad_usage = 2, simulation_error = 3 };

struct Tally {
  int passed = 0;
  int failed = 0;
  int skipped = 0;
  int exit_code = all_passed;

  void worsen(int code) { exit_code = std::max(exit_code, code); }
};

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "pass";
    case Verdict::failed:
      return "FAIL";
    case Verdict::skipped:
      return "skip";
    case Verdict::broken:
      break;
  }
  return "ERROR";
}

bool is_image_there(const Order& order, std::ostream& err) {
  if (order.on == "host" || std::filesystem::exists(order.image)) {
    return true;
  }
  fmt::print(err,
             "no image at {}\n  build it:       cmake --build build --target firmware\n"
             "  or choose one:  --image FILE, or play without one: --on host\n",
             order.image);
  return false;
}

// Empty, with everything that is wrong told on `err`, unless all files can be played.
std::vector<Scenario> load_all(const Order& order, std::ostream& err) {
  std::vector<Scenario> scenarios;
  bool all_good = true;
  for (const std::string& file : order.files) {
    try {
      scenarios.push_back(load_scenario(file));
    } catch (const BadScenario& bad) {
      err << bad.what() << '\n';
      all_good = false;
    }
  }
  return all_good ? scenarios : std::vector<Scenario>{};
}

class Batch {
 public:
  Batch(const Order& order, std::ostream& out, std::ostream& err) : order_(order), out_(out), err_(err) {}

  void play(const Scenario& scenario) {
    if (order_.on != "both") {
      play_on(order_.on, scenario);
      return;
    }
    const Result avr = play_on("avr", scenario);
    const Result host = play_on("host", scenario);
    if (avr.verdict != Verdict::skipped && host.verdict != Verdict::skipped) {
      compare(avr, host);
    }
  }

  Tally tally;

 private:
  Result play_on(const std::string& board, const Scenario& scenario) {
    Request request;
    request.board = board;
    request.image = order_.image;
    request.seed = order_.seed;
    request.wants_story = order_.files.size() == 1 && order_.on != "both" && !order_.is_quiet;
    request.wants_log = order_.wants_log;
    request.palette = order_.palette;
    if (!order_.folder.empty()) {
      request.folder =
          order_.on == "both" ? std::filesystem::path(order_.folder) / board : std::filesystem::path(order_.folder);
    }
    const auto start = std::chrono::steady_clock::now();
    Result result = scenario::play(scenario, request, out_);
    tell_speed(board, result, std::chrono::steady_clock::now() - start);
    tell(board, scenario, result);
    count(result.verdict);
    return result;
  }

  void tell(const std::string& board, const Scenario& scenario, const Result& result) {
    const report::Tone tone = result.verdict == Verdict::passed || result.verdict == Verdict::skipped
                                  ? report::Tone::heading
                                  : report::Tone::alarm;
    fmt::print(out_, "{}  {:<4}  {}", order_.palette.paint(tone, fmt::format("{:<5}", word_of(result.verdict))), board,
               scenario.file);
    if (result.verdict == Verdict::skipped) {
      fmt::print(out_, "  ({})\n", result.report);
      return;
    }
    fmt::print(out_, "  {:.3f} s  {:016x}\n{}", seconds(result.simulated), result.transcript.hash(), result.report);
    for (const std::string& file : result.files) {
      fmt::print(out_, "       wrote {}\n", file);
    }
    for (const std::string& remark : result.remarks) {
      fmt::print(out_, "       {}\n", remark);
    }
    out_.flush();
  }

  void tell_speed(const std::string& board, const Result& result, std::chrono::steady_clock::duration taken) {
    const double wall = std::chrono::duration<double>(taken).count();
    if (order_.is_verbose && wall > 0) {
      fmt::print(err_, "{}: {:.3f} s simulated in {:.3f} s, {:.1f} x real time\n", board, seconds(result.simulated),
                 wall, seconds(result.simulated) / wall);
    }
  }

  void count(Verdict verdict) {
    (verdict == Verdict::passed ? tally.passed : verdict == Verdict::skipped ? tally.skipped : tally.failed) += 1;
    if (verdict == Verdict::failed) {
      tally.worsen(some_failed);
    } else if (verdict == Verdict::broken) {
      tally.worsen(simulation_error);
    }
  }

  void compare(const Result& avr, const Result& host) {
    const auto difference = report::first_difference({"avr", avr.transcript}, {"host", host.transcript});
    if (difference) {
      fmt::print(out_, "       transcripts disagree: {}", *difference);
      tally.worsen(some_failed);
      ++tally.failed;
      return;
    }
    fmt::print(out_, "       transcripts agree: {:016x} ({} cycles, {} bytes)\n", avr.transcript.hash(),
               avr.transcript.cycles().size() - 1, avr.transcript.byte_count());
  }

  const Order& order_;
  std::ostream& out_;
  std::ostream& err_;
};

}  // namespace

int play_all(const Order& order, std::ostream& out, std::ostream& err) {
  const auto scenarios = load_all(order, err);
  if (scenarios.empty() || !is_image_there(order, err)) {
    return bad_usage;
  }
  Batch batch(order, out, err);
  for (const Scenario& scenario : scenarios) {
    batch.play(scenario);
  }
  const Tally& tally = batch.tally;
  if (scenarios.size() > 1 || order.on == "both") {
    fmt::print(out, "{} passed, {} failed{}\n", tally.passed, tally.failed,
               tally.skipped > 0 ? fmt::format(", {} skipped", tally.skipped) : "");
  }
  return tally.exit_code;
}

}  // namespace simulation::scenario
