// The run over time: a table of numbers (CSV), a gnuplot script, and, where gnuplot is installed, the picture.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "simulation/report/facts.hpp"
#include "simulation/report/story.hpp"

namespace simulation::report {

class Plot : public Observer {
 public:
  explicit Plot(const Facts& facts) : facts_(facts) {}

  void on_sample(const Sample& sample) override;

  void write_csv(std::ostream& out) const;
  // A script that draws `csv` into `svg`, with the headings as marks. File names as gnuplot shall open them.
  void write_script(std::ostream& out, const std::string& title, const std::vector<Story::Moment>& headings,
                    const std::string& csv, const std::string& svg) const;

 private:
  struct Row {
    double time, stick_speed, stick_direction, left_wheel, right_wheel, left_duty, right_duty;
    bool brakes_engaged, drive_inhibited, needs_neutral, limp, power_latch, cable_cut;
    int system_state;
  };

  const Facts& facts_;
  std::vector<Row> rows_;
  Time next_{};
};

// Runs gnuplot on the script. False if there is no gnuplot or it failed.
bool draw(const std::filesystem::path& folder, const std::string& script);

}  // namespace simulation::report
