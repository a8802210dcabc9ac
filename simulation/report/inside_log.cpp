#include "simulation/report/inside_log.hpp"

#include <fmt/format.h>

#include <vector>

#include "spm/words.hpp"

namespace simulation::report {
namespace {

template <typename Item, typename Set>
std::string words_of_all(Set some, std::uint8_t count) {
  std::vector<std::string> words;
  for (std::uint8_t i = 0; i < count; ++i) {
    if (some.has(static_cast<Item>(i))) {
      words.emplace_back(spm::words_of(static_cast<Item>(i)));
    }
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string tell_inhibits(spm::Inhibits inhibits) {
  return inhibits.empty() ? "nothing forbids driving"
                          : "not driving because: " + words_of_all<spm::Inhibit>(inhibits, spm::inhibit_count);
}

std::string tell_faults(spm::FaultSet faults) {
  return faults.empty() ? "no fault any more" : "faults: " + words_of_all<spm::Fault>(faults, spm::fault_count);
}

InsideLog::InsideLog(World& world, Page& page, BusLog& log)
    : view_(dynamic_cast<const InsideView*>(&world.board())), page_(page), log_(log) {}

void InsideLog::on_sample(const Sample& sample) {
  if (view_ == nullptr) {
    return;
  }
  if (!sample.spm_powered) {
    before_.reset();
    return;
  }
  const Inside now = view_->inside();
  if (!before_ || now.inhibits != before_->inhibits) {
    tell(tell_inhibits(now.inhibits), sample.at);
  }
  const spm::FaultSet faults_before = before_ ? before_->faults : spm::FaultSet();
  if (now.faults != faults_before) {
    tell(tell_faults(now.faults), sample.at);
  }
  before_ = now;
}

void InsideLog::tell(const std::string& sentence, Time at) {
  log_.unfold();
  page_.add(at, Page::Source::bus, Tone::faint, fmt::format("{:9.3f} s   [inside] {}", seconds(at), sentence));
}

}  // namespace simulation::report
