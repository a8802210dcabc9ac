// The lines of a run, in order of time, on one or more streams. Lines may come a little late (a packet is known
// when it has ended); the page holds the newest back for a moment and sorts them in.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "simulation/time.hpp"

namespace simulation::report {

enum class Tone { plain, heading, story, sr, spm, faint, alarm };

// Escape sequences, or nothing when colour is off.
class Palette {
 public:
  explicit Palette(bool has_colour = false) : has_colour_(has_colour) {}
  std::string paint(Tone tone, const std::string& text) const;

 private:
  bool has_colour_;
};

// True for a terminal, unless NO_COLOR is set.
bool wants_colour(int file_descriptor);

class Page {
 public:
  enum class Source { story, bus };

  // Prints to `out` too, the bus only if wanted. `out` must outlive the page.
  void add_reader(std::ostream& out, Palette palette, bool wants_bus);

  void add(Time at, Source source, Tone tone, const std::string& text);
  // Prints what is older than `now` by more than any packet takes.
  void advance(Time now);
  void finish();

 private:
  struct Line {
    Time at{};
    Source source = Source::story;
    Tone tone = Tone::plain;
    std::string text;
  };
  struct Reader {
    std::ostream* out;
    Palette palette;
    bool wants_bus;
  };
  void print_until(Time limit);

  std::vector<Reader> readers_;
  std::vector<Line> waiting_;
};

}  // namespace simulation::report
