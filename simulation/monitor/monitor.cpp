#include "simulation/monitor/monitor.hpp"

#include <algorithm>

namespace simulation::monitor {
namespace {

constexpr std::size_t moment_count = 5;

}  // namespace

Monitor::Monitor(const std::vector<std::string>& except) : watched_(moment_count) {
  for (const Clause& clause : clauses()) {
    if (std::find(except.begin(), except.end(), clause.id) == except.end()) {
      watched_[static_cast<std::size_t>(clause.moment)].push_back(&clause);
    }
  }
}

void Monitor::on_byte(const BusByte& byte) {
  if (!scene_.take(byte)) {
    return;
  }
  judge(Moment::character, byte.start);
  if (scene_.said.begins_turn) {
    judge(Moment::turn, byte.start);
  }
  if (scene_.said.packet) {
    judge(Moment::packet, byte.end);
  }
  if (scene_.said.general) {
    judge(Moment::general, byte.end);
  }
}

void Monitor::on_sample(const Sample& sample) {
  scene_.take(sample);
  judge(Moment::millisecond, sample.at);
}

// A clause that was broken is not asked again.
void Monitor::judge(Moment moment, Time at) {
  Watched& watched = watched_[static_cast<std::size_t>(moment)];
  std::erase_if(watched, [&](const Clause* clause) {
    if (!clause->is_broken(scene_)) {
      return false;
    }
    breaches_.push_back({clause, at, scene_.tell()});
    return true;
  });
}

}  // namespace simulation::monitor
