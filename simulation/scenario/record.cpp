#include "simulation/scenario/record.hpp"

#include <fstream>
#include <stdexcept>

namespace simulation::scenario {
namespace {

std::ofstream open(const std::filesystem::path& path, std::vector<std::string>& files) {
  std::ofstream out(path);
  if (!out) {
    throw std::runtime_error("cannot write " + path.string());
  }
  files.push_back(path.string());
  return out;
}

}  // namespace

Record::Record(const Scenario& scenario, const report::Facts& facts, report::Page& page, World& world)
    : title_(scenario.name), stem_(std::filesystem::path(scenario.file).stem().string()), plot_(facts) {
  page.add_reader(log_text_, report::Palette(false), true);
  world.observe(waveform_);
  world.observe(plot_);
}

void Record::write(const std::filesystem::path& folder, const report::Story& story, std::vector<std::string>& files,
                   std::vector<std::string>& remarks) {
  std::filesystem::create_directories(folder);
  open(folder / (stem_ + ".log"), files) << log_text_.str();
  auto vcd = open(folder / (stem_ + ".vcd"), files);
  waveform_.write(vcd);
  auto csv = open(folder / (stem_ + ".csv"), files);
  plot_.write_csv(csv);
  csv.close();
  auto script = open(folder / (stem_ + ".gp"), files);
  plot_.write_script(script, title_, story.headings(), stem_ + ".csv", stem_ + ".svg");
  script.close();
  if (report::draw(folder, stem_ + ".gp")) {
    files.push_back((folder / (stem_ + ".svg")).string());
  } else {
    remarks.push_back("no picture: gnuplot is not installed or failed (apt-get install gnuplot-nox)");
  }
}

}  // namespace simulation::scenario
