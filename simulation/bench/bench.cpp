#include "simulation/bench/bench.hpp"

#include <fmt/format.h>

#include <fstream>

#include "simulation/bench/json.hpp"
#include "simulation/bench/measure.hpp"
#include "simulation/bench/page.hpp"
#include "simulation/bench/targets.hpp"

namespace simulation::bench {
namespace {

constexpr int missed = 1;
constexpr int unusable = 2;
constexpr int broken = 3;

int judge(const Figures& figures, const std::vector<Target>& targets, std::ostream& err) {
  for (const RunFigures* run : {&figures.idle, &figures.heavy}) {
    for (const std::string& complaint : run->complaints) {
      err << fmt::format("the chip complains, {} traffic: {}\n", run->name, complaint);
    }
    if (!run->complaints.empty()) {
      return broken;
    }
  }
  for (const NoiseFigures& noise : figures.noise) {
    for (const std::string& complaint : noise.complaints) {
      err << fmt::format("the chip complains, noise {}: {}\n", noise.name, complaint);
      return broken;
    }
  }
  int code = 0;
  for (const Target& target : targets) {
    if (!target.is_met) {
      err << fmt::format("target missed: {}: wanted {}, seen {}\n", target.what, target.wanted, target.seen);
      code = missed;
    }
  }
  return code;
}

}  // namespace

int run(const Order& order, std::ostream& out, std::ostream& err) {
  Figures figures;
  try {
    figures = measure(order.image, order.minutes);
  } catch (const std::exception& error) {
    err << error.what() << '\n';
    return unusable;
  }
  const std::vector<Target> all = targets(figures);
  out << (order.wants_json ? tell_json(figures, all) : tell_tables(figures, all));
  if (order.page) {
    std::ofstream page(*order.page);
    page << tell_page(figures, all);
    if (!page.flush()) {
      err << fmt::format("cannot write '{}'\n", *order.page);
      return unusable;
    }
  }
  return judge(figures, all, err);
}

}  // namespace simulation::bench
