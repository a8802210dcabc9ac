// The files of a run: full bus log, waveform, plot.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "simulation/report/page.hpp"
#include "simulation/report/plot.hpp"
#include "simulation/report/story.hpp"
#include "simulation/report/vcd.hpp"
#include "simulation/scenario/step.hpp"

namespace simulation::scenario {

class Record {
 public:
  // Observes the world and reads the page from now on; must outlive the run.
  Record(const Scenario& scenario, const report::Facts& facts, report::Page& page, World& world);

  // Writes NAME.log, .vcd, .csv, .gp and .svg, NAME being the scenario file's; makes the folder if need be.
  // Throws std::runtime_error if it cannot.
  void write(const std::filesystem::path& folder, const report::Story& story, std::vector<std::string>& files,
             std::vector<std::string>& remarks);

 private:
  std::string title_;
  std::string stem_;
  std::ostringstream log_text_;
  report::Waveform waveform_;
  report::Plot plot_;
};

}  // namespace simulation::scenario
