// Minimum, median and maximum of many readings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace simulation::bench {

struct Spread {
  std::size_t count = 0;  // 0: there was nothing to read, and the rest is 0
  double least = 0;
  double median = 0;
  double most = 0;
};

class Readings {
 public:
  void add(double value) { values_.push_back(value); }
  void clear() { values_.clear(); }

  Spread spread() const {
    if (values_.empty()) {
      return {};
    }
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    return {sorted.size(), sorted.front(), sorted[sorted.size() / 2], sorted.back()};
  }

 private:
  std::vector<double> values_;
};

}  // namespace simulation::bench
