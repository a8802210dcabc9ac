// What is wrong with a scenario file, and where.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace simulation::scenario {

// Counted from 1, as editors do; line 0 stands for the file as a whole.
struct Mark {
  int line = 0;
  int column = 0;

  bool operator==(const Mark&) const = default;
};

struct Problem {
  Mark mark;
  std::string text;
};

// "file.yaml:12:9: 60 has no unit: write 60ms"
std::string show(const std::string& file, const Problem& problem);

// Thrown when a file cannot be played; carries everything that is wrong with it, in order of lines.
class BadScenario : public std::runtime_error {
 public:
  BadScenario(const std::string& file, std::vector<Problem> problems);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace simulation::scenario
