// pilotfish: plays scenarios on the simulated chair, measures the image, cuts its supply and reads its log.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "simulation/bench/bench.hpp"
#include "simulation/eeprom/command.hpp"
#include "simulation/monitor/clause.hpp"
#include "simulation/powercut/powercut.hpp"
#include "simulation/scenario/batch.hpp"
#include "simulation/scenario/lexicon.hpp"

namespace {

using namespace simulation;

constexpr const char* version = "pilotfish 0.1.0";
constexpr int exit_bad_usage = 2;

constexpr const char* examples = R"(Examples
  pilotfish run simulation/scenarios/first_drive.yaml --log
      the flashed image drives the chair: story, decoded bus and a table of numbers
  pilotfish run simulation/scenarios/*.yaml --on both
      every scenario on the image in simavr and on the host build; their bus transcripts must agree
  pilotfish run simulation/scenarios/first_drive.yaml --out build/first_drive
      also writes a plot (SVG), a waveform (VCD for GTKWave, PulseView, sigrok-cli) and the full log
  pilotfish bench
      answer times, bus, CPU load and interrupts of the image, on an idle bus and under the heaviest traffic
  pilotfish powercut
      the supply fails at every byte that the image writes into its EEPROM, and the image starts again
  pilotfish events eeprom.hex
      the event log of a chip in words, from what avrdude has read; or of a scenario: --after FILE
  pilotfish list-steps
      the words of the scenario language, with units and examples

Exit codes
  0  everything as expected    1  an expectation or a target was not met, a case is not safe, or the machines disagree
  2  a file or the command line is wrong    3  the simulation itself failed)";

// Beside this program, where the build puts the image: build/pilotfish and build/firmware/spm.elf.
std::string default_image() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  return (program.parent_path() / "firmware" / "spm.elf").string();
}

void add_run(CLI::App& app, scenario::Order& order) {
  auto* run = app.add_subcommand("run", "Plays scenario files and tells whether all expectations were met");
  run->add_option("file", order.files, "Scenario files (YAML)")->required();
  run->add_option("--on", order.on, "avr: the image in simavr; host: the same code, native; both: and compare")
      ->check(CLI::IsMember({"avr", "host", "both"}))
      ->capture_default_str();
  run->add_option("--image", order.image, "The image for avr, ELF or HEX")->capture_default_str();
  run->add_option("--out", order.folder, "Writes plot, waveform and log of each run into this folder");
  run->add_option("--seed", order.seed, "For everything random; overrides the file's");
  run->add_flag("--log", order.wants_log, "Prints the bus, decoded");
  run->add_flag("-q,--quiet", order.is_quiet, "One line a file, even for a single one");
  run->add_flag("-v,--verbose", order.is_verbose, "Tells on stderr how fast the simulation was");
}

void add_bench(CLI::App& app, bench::Order& order) {
  auto* command = app.add_subcommand("bench", "Measures the image on an idle bus and under the heaviest traffic");
  command->add_option("--minutes", order.minutes, "Simulated minutes of each")
      ->check(CLI::Range(0.01, 1e5))
      ->capture_default_str();
  command->add_option("--image", order.image, "The image, ELF or HEX")->capture_default_str();
  command->add_flag("--json", order.wants_json, "Prints JSON instead of tables");
  command->add_option("--write", order.page, "Writes the page, docs/performance.md, into this file");
}

void add_powercut(CLI::App& app, powercut::Order& order) {
  auto* command =
      app.add_subcommand("powercut", "Cuts the supply at every byte that the image writes, and starts it again");
  command->add_flag("--all", order.wants_all, "Every outcome of every byte, and every pair of two cuts: minutes");
  command->add_option("--seed", order.seed, "For the outcomes that are drawn")->capture_default_str();
  command->add_option("--image", order.image, "The image, ELF or HEX; its .eep file must lie beside it")
      ->capture_default_str();
  command->add_flag("-v,--verbose", order.is_verbose, "Tells on stderr how fast it was");
}

void add_events(CLI::App& app, eeprom::EventsOrder& order) {
  auto* command = app.add_subcommand("events", "Prints the event log of an EEPROM in words");
  auto* file = command->add_option("file", order.file, "An EEPROM as avrdude reads it: Intel HEX, .eep or raw bytes");
  auto* after = command->add_option("--after", order.scenario, "Instead: what this scenario leaves in the EEPROM");
  after->excludes(file);
  command->add_option("--on", order.on, "The machine that plays it")
      ->check(CLI::IsMember({"avr", "host"}))
      ->capture_default_str();
  command->add_option("--image", order.image, "The image for avr, ELF or HEX")->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Pilotfish: a simulated power wheelchair around the firmware of its power module");
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  app.footer(examples);

  scenario::Order order;
  order.image = default_image();
  order.palette = report::Palette(report::wants_colour(STDOUT_FILENO));
  add_run(app, order);
  bench::Order bench_order;
  bench_order.image = default_image();
  add_bench(app, bench_order);
  powercut::Order powercut_order;
  powercut_order.image = default_image();
  powercut_order.palette = order.palette;
  add_powercut(app, powercut_order);
  eeprom::EventsOrder events_order;
  events_order.image = default_image();
  add_events(app, events_order);
  app.add_subcommand("list-steps", "Prints every step, condition and fault of the scenario language");
  app.add_subcommand("list-clauses", "Prints what the monitor watches in every run");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_bad_usage;
  }
  if (app.got_subcommand("list-steps")) {
    std::cout << scenario::tell_lexicon();
    return 0;
  }
  if (app.got_subcommand("list-clauses")) {
    std::cout << monitor::tell_clauses();
    return 0;
  }
  if (app.got_subcommand("bench")) {
    return bench::run(bench_order, std::cout, std::cerr);
  }
  if (app.got_subcommand("powercut")) {
    return powercut::run(powercut_order, std::cout, std::cerr);
  }
  if (app.got_subcommand("events")) {
    return eeprom::tell_events(events_order, std::cout, std::cerr);
  }
  return scenario::play_all(order, std::cout, std::cerr);
}
