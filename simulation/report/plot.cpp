#include "simulation/report/plot.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "bus/shark/fields.hpp"

namespace simulation::report {
namespace {

namespace general = bus::shark::spm_general;

constexpr Time resolution = 5ms;

// One panel of the picture.
struct Curve {
  int column;
  const char* title;
  const char* colour;
};
struct Panel {
  const char* label;
  const char* range;
  double key;  // height of the legend, where the curves leave room for it
  std::array<Curve, 2> curves;
};
constexpr std::array panels{
    Panel{"stick / %", "[-110:110]", 0.22, {{{2, "forward", "#1f77b4"}, {3, "right", "#ff7f0e"}}}},
    Panel{"wheel speed / (m/s)", "[*:*]", 0.96, {{{4, "left", "#2ca02c"}, {5, "right", "#d62728"}}}},
    Panel{"PWM duty / %", "[-110:110]", 0.22, {{{6, "left", "#2ca02c"}, {7, "right", "#d62728"}}}},
};

struct Bar {
  int column;
  const char* title;
  const char* colour;
};
constexpr std::array bars{
    Bar{8, "brakes engaged", "#7f7f7f"}, Bar{9, "drive inhibited", "#9467bd"}, Bar{10, "needs neutral", "#bcbd22"},
    Bar{11, "LIMP", "#ff7f0e"},          Bar{12, "power latch", "#17becf"},    Bar{13, "cable cut", "#d62728"},
};

bool reports(const Facts& facts, base::Field field) {
  return facts.spm_general() && base::is_set(facts.spm_general()->data(), field);
}

std::string quoted(std::string text) {
  for (char& letter : text) {
    if (letter == '"' || letter == '\\') {
      letter = '\'';
    }
  }
  return '"' + text + '"';
}

void write_heading_marks(std::ostream& out, const std::vector<Story::Moment>& headings, bool with_text) {
  int tag = 1;
  for (const auto& heading : headings) {
    const double at = seconds(heading.at);
    fmt::print(out, "set arrow {} from {:.3f}, graph 0 to {:.3f}, graph 1 nohead lc rgb '#bbbbbb' dt 2 back\n", tag, at,
               at);
    if (with_text) {
      fmt::print(out, "set label {} {} at {:.3f}, graph 1.04 rotate by 22 left noenhanced font ',10'\n", tag,
                 quoted(heading.text), at);
    }
    ++tag;
  }
}

void write_bars(std::ostream& out, const std::string& csv) {
  fmt::print(out, "set lmargin at screen 0.13\nset tmargin at screen 0.27\nset bmargin at screen 0.07\n");
  fmt::print(out, "set xlabel 'time / s'\nset format x '%g'\nunset ylabel\nset yrange [-0.2:{}]\nunset key\n",
             bars.size());
  fmt::print(out, "set ytics (");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    fmt::print(out, "{}'{}' {}", i == 0 ? "" : ", ", bars[i].title, static_cast<double>(i) + 0.35);
  }
  fmt::print(out, ")\nplot ");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    fmt::print(out, "{}'{}' using 1:({}):({} + 0.7*${}) with filledcurves lc rgb '{}'", i == 0 ? "" : ", \\\n     ",
               csv, i, i, bars[i].column, bars[i].colour);
  }
  out << '\n';
}

constexpr std::size_t most_rows = 1500;

}  // namespace

void Plot::on_sample(const Sample& sample) {
  if (sample.at < next_) {
    return;
  }
  next_ = sample.at + resolution;
  const int state = facts_.spm_general() ? base::read(facts_.spm_general()->data(), general::system_state) : 0;
  rows_.push_back({seconds(sample.at), (sample.controls.speed - 512) / 5.11, (sample.controls.direction - 512) / 5.11,
                   facts_.left_wheel(), facts_.right_wheel(), facts_.left_duty() * 100, facts_.right_duty() * 100,
                   !sample.pins.left_brake_release && !sample.pins.right_brake_release,
                   reports(facts_, general::drive_inhibited), reports(facts_, general::sr_drive_modified),
                   reports(facts_, general::slowdown), sample.pins.power_latch, facts_.is_cable_cut(), state});
}

void Plot::write_csv(std::ostream& out) const {
  out << "time s,stick forward %,stick right %,left wheel m/s,right wheel m/s,left duty %,right duty %,"
         "brakes engaged,drive inhibited,needs neutral,limp,power latch,cable cut,system state\n";
  // More points than the picture has pixels would only make it large.
  const std::size_t stride = 1 + rows_.size() / most_rows;
  for (std::size_t i = 0; i < rows_.size(); i += stride) {
    const Row& r = rows_[i];
    fmt::print(out, "{:.3f},{:.1f},{:.1f},{:.4f},{:.4f},{:.1f},{:.1f},{:d},{:d},{:d},{:d},{:d},{:d},{}\n", r.time,
               r.stick_speed, r.stick_direction, r.left_wheel, r.right_wheel, r.left_duty, r.right_duty,
               r.brakes_engaged, r.drive_inhibited, r.needs_neutral, r.limp, r.power_latch, r.cable_cut,
               r.system_state);
  }
}

void Plot::write_script(std::ostream& out, const std::string& title, const std::vector<Story::Moment>& headings,
                        const std::string& csv, const std::string& svg) const {
  fmt::print(out, "set terminal svg size 1200,1000 dynamic font 'sans,12' background '#ffffff'\nset output '{}'\n",
             svg);
  fmt::print(out, "set datafile separator ','\nset multiplot\nset grid lc rgb '#e8e8e8'\nset xrange [0:{:.3f}]\n",
             rows_.empty() ? 1.0 : rows_.back().time);
  fmt::print(out, "set label 100 {} at screen 0.5, 0.975 center font ',16' noenhanced\n", quoted(title));
  fmt::print(out, "set rmargin at screen 0.90\nset lmargin at screen 0.13\nset format x ''\n");
  double top = 0.84;
  constexpr double height = 0.17;
  constexpr double gap = 0.02;
  for (const Panel& panel : panels) {
    write_heading_marks(out, headings, &panel == &panels.front());
    fmt::print(out, "set tmargin at screen {:.3f}\nset bmargin at screen {:.3f}\n", top, top - height);
    fmt::print(out, "set key at graph 0.995, {} right top opaque horizontal\n", panel.key);
    fmt::print(out, "set ylabel '{}'\nset yrange {}\nplot ", panel.label, panel.range);
    for (const Curve& curve : panel.curves) {
      fmt::print(out, "{}'{}' using 1:{} with lines lw 1.6 lc rgb '{}' title '{}'",
                 &curve == &panel.curves.front() ? "" : ", ", csv, curve.column, curve.colour, curve.title);
    }
    fmt::print(out, "\nunset label\n");
    top -= height + gap;
  }
  write_bars(out, csv);
  out << "unset multiplot\n";
}

bool draw(const std::filesystem::path& folder, const std::string& script) {
  const pid_t child = fork();
  if (child == 0) {
    // It warns of a chair that never moves: nothing a person needs to see.
    if (chdir(folder.c_str()) == 0 && freopen("/dev/null", "w", stderr) != nullptr) {
      execlp("gnuplot", "gnuplot", script.c_str(), static_cast<char*>(nullptr));
    }
    _exit(127);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace simulation::report
