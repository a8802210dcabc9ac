#include "simulation/report/page.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace simulation::report {
namespace {

constexpr Time patience = 50ms;

const char* escape(Tone tone) {
  switch (tone) {
    case Tone::heading:
      return "\033[1m";
    case Tone::story:
      return "\033[33m";
    case Tone::sr:
      return "\033[36m";
    case Tone::spm:
      return "\033[32m";
    case Tone::faint:
      return "\033[2m";
    case Tone::alarm:
      return "\033[1;31m";
    case Tone::plain:
      break;
  }
  return "";
}

}  // namespace

std::string Palette::paint(Tone tone, const std::string& text) const {
  if (!has_colour_ || tone == Tone::plain) {
    return text;
  }
  return fmt::format("{}{}\033[0m", escape(tone), text);
}

bool wants_colour(int file_descriptor) {
  const char* refusal = std::getenv("NO_COLOR");
  return isatty(file_descriptor) != 0 && (refusal == nullptr || *refusal == '\0');
}

void Page::add_reader(std::ostream& out, Palette palette, bool wants_bus) {
  readers_.push_back({&out, palette, wants_bus});
}

void Page::add(Time at, Source source, Tone tone, const std::string& text) {
  const auto place = std::upper_bound(waiting_.begin(), waiting_.end(), at,
                                      [](Time time, const Line& line) { return time < line.at; });
  waiting_.insert(place, {at, source, tone, text});
}

void Page::advance(Time now) {
  print_until(now - patience);
}

void Page::finish() {
  print_until(Time::max());
  for (const Reader& reader : readers_) {
    reader.out->flush();
  }
}

void Page::print_until(Time limit) {
  auto line = waiting_.begin();
  for (; line != waiting_.end() && line->at <= limit; ++line) {
    for (const Reader& reader : readers_) {
      if (line->source == Source::story || reader.wants_bus) {
        *reader.out << reader.palette.paint(line->tone, line->text) << '\n';
      }
    }
  }
  waiting_.erase(waiting_.begin(), line);
}

}  // namespace simulation::report
