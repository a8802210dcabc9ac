#include <catch2/catch.hpp>
#include <string>

#include "simulation/bench/json.hpp"
#include "simulation/bench/page.hpp"
#include "simulation/bench/targets.hpp"

namespace {

using namespace simulation::bench;

RunFigures good_run(const std::string& name) {
  RunFigures run;
  run.name = name;
  run.seconds = 60;
  run.answer = {100, 8, 10, 50};
  run.pause = {900, 0, 0, 1};
  run.cycles = 100;
  run.load = 0.399;
  run.interrupts = {{"USART0_RX", 100, 10, 100, 319}};
  run.locked = {160, "main"};
  run.stack_used = 700;
  return run;
}

NoiseFigures good_noise(const std::string& name) {
  NoiseFigures run;
  run.name = name;
  run.hears_remote = name == "in the gaps";
  run.seconds = 3;
  run.load = 0.599;
  run.ticks = 3001;
  run.answer = {149, 0, 10, 100};
  run.stop_begins_ms = 63;
  run.stop_lasts_ms = 1500;
  run.is_back = true;
  return run;
}

Figures good_figures() {
  Figures figures;
  figures.image = {"spm.elf", "GCC: (GNU) 5.4.0", 20000, 1000, 700};
  figures.idle = good_run("idle");
  figures.heavy = good_run("heaviest");
  figures.noise = {good_noise("all of the time"), good_noise("in the gaps")};
  return figures;
}

// The names of all targets that are missed.
std::string missed(const Figures& figures) {
  std::string names;
  for (const Target& target : targets(figures)) {
    names += target.is_met ? "" : target.what + "; ";
  }
  return names;
}

TEST_CASE("figures that just meet their targets meet them") {
  CHECK(missed(good_figures()) == "");
}

TEST_CASE("each number beside noise that is just too bad is named", "[H-23]") {
  Figures figures = good_figures();
  NoiseFigures& all = figures.noise[0];
  NoiseFigures& gaps = figures.noise[1];
  SECTION("too much to do") {
    all.load = 0.6;
    CHECK(missed(figures) == "CPU load, noise all of the time; ");
  }
  SECTION("a lost millisecond and one more") {
    all.ticks = 2998;
    CHECK(missed(figures) == "milliseconds counted, noise all of the time; ");
  }
  SECTION("a late stop") {
    all.stop_begins_ms = 63.1;
    CHECK(missed(figures) == "emergency stop begins, noise all of the time; ");
  }
  SECTION("no stop") {
    all.stop_begins_ms = all.stop_lasts_ms = {};
    CHECK(missed(figures) ==
          "emergency stop begins, noise all of the time; emergency stop ends, noise all of the time; ");
  }
  SECTION("a stop that lasts") {
    gaps.stop_lasts_ms = 1500.1;
    CHECK(missed(figures) == "emergency stop ends, noise in the gaps; ");
  }
  SECTION("a stop that turns round") {
    gaps.grew = true;
    CHECK(missed(figures) == "emergency stop ends, noise in the gaps; ");
  }
  SECTION("a late answer") {
    gaps.answer.most = 100.1;
    CHECK(missed(figures) == "answer, noise in the gaps; ");
  }
  SECTION("two turns without an answer") {
    gaps.answer.count = 148;
    CHECK(missed(figures) == "answer, noise in the gaps; ");
  }
  SECTION("a word into the noise") {
    all.characters_said = 1;
    CHECK(missed(figures) == "said into the noise, noise all of the time; ");
  }
  SECTION("a lost character") {
    all.overruns = 1;
    CHECK(missed(figures) == "lost in the UART, noise all of the time; ");
  }
  SECTION("no way back") {
    all.is_back = false;
    CHECK(missed(figures) == "turns answered afterwards, noise all of the time; ");
  }
}

TEST_CASE("each number that is just too bad is named") {
  Figures figures = good_figures();
  SECTION("answer too late") {
    figures.heavy.answer.most = 50.1;
    CHECK(missed(figures) == "answer, heaviest traffic; ");
  }
  SECTION("answer into the remote's turn") {
    figures.idle.answer.least = -0.1;
    CHECK(missed(figures) == "answer, idle traffic; ");
  }
  SECTION("no answer at all") {
    figures.idle.answer = {};
    CHECK(missed(figures) == "answer, idle traffic; ");
  }
  SECTION("a pause") {
    figures.heavy.pause.most = 1.1;
    CHECK(missed(figures) == "idle time inside the turn, heaviest traffic; ");
  }
  SECTION("a cycle") {
    figures.heavy.broken_cycles = 1;
    CHECK(missed(figures) == "turns that lie in their cycle, heaviest traffic; ");
  }
  SECTION("an interrupt") {
    figures.heavy.interrupts[0].longest_cycles = 320;
    CHECK(missed(figures) == "longest USART0_RX, heaviest traffic; ");
  }
  SECTION("interrupts off") {
    figures.heavy.locked.cycles = 161;
    CHECK(missed(figures) == "interrupts off, heaviest traffic; ");
  }
  SECTION("load") {
    figures.heavy.load = 0.4;
    CHECK(missed(figures) == "CPU load, heaviest traffic; ");
  }
  SECTION("an overrun") {
    figures.heavy.losses.overruns = 1;
    CHECK(missed(figures) == "lost bytes, heaviest traffic; ");
  }
  SECTION("a character of the programmer") {
    figures.heavy.losses.unreturned = 1;
    CHECK(missed(figures) == "lost bytes, heaviest traffic; ");
  }
  SECTION("a complaint") {
    figures.idle.complaints.emplace_back("cycle 1: a wild write");
    CHECK(missed(figures) == "complaints of the chip, idle traffic; ");
  }
  SECTION("a stack deeper than was proven") {
    figures.heavy.stack_used = 701;
    CHECK(missed(figures) == "stack, heaviest traffic; ");
  }
}

TEST_CASE("page and JSON say what was measured") {
  Figures figures = good_figures();
  figures.heavy.load = 0.5;
  figures.examples = {{"normal", 10, 10, 0, 6720, 5730, 5725}};
  const auto all = targets(figures);
  using Catch::Matchers::Contains;
  CHECK_THAT(tell_page(figures, all), Contains("| CPU load | 39.9 % | 50.0 % |") && Contains("GCC: (GNU) 5.4.0") &&
                                          Contains("8.0 / 10.0 / 50.0") && Contains("180 : 1") &&
                                          Contains("| normal | 10 + 10 + 0 = 20 | 6.72 ms, 33.6 % |") &&
                                          Contains("MISSED"));
  CHECK_THAT(tell_json(figures, all), Contains("\"cpu_load\": 0.5") && Contains("\"CPU load, heaviest traffic\""));
}

}  // namespace
