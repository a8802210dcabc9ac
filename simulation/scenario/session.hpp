// One scenario on one machine, from power to verdict, with the reports that were asked for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "simulation/report/page.hpp"
#include "simulation/report/transcript.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

struct Request {
  std::string board = "avr";  // avr or host
  std::string image;          // for avr
  std::optional<std::uint64_t> seed;
  bool wants_story = false;  // sentences and the table
  bool wants_log = false;    // the decoded bus among them, and the event log behind
  report::Palette palette;
  std::optional<std::filesystem::path> folder;  // for plot, waveform and full log
};

// `broken`: the simulation, not the expectation, went wrong: a crashed core, an unusable image.
enum class Verdict { passed, failed, broken, skipped };

struct Result {
  Verdict verdict = Verdict::broken;
  std::string report;  // of a failure, several lines; or why it was skipped or broke
  report::Transcript transcript;
  Time simulated{};
  std::vector<std::uint8_t> eeprom;  // as it was left; empty if it was never played
  std::vector<std::string> files;    // written
  std::vector<std::string> remarks;  // such as a missing gnuplot
};

Result play(const Scenario& scenario, const Request& request, std::ostream& out);

}  // namespace simulation::scenario
