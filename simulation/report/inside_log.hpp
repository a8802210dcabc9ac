// Why the power module does not drive, and which faults it sees, in its own words, among the lines of the bus. Seen
// from inside, so it is no part of any transcript; on a board that does not let anybody look in, nothing is told.
#pragma once

#include <optional>
#include <string>

#include "simulation/board/inside_view.hpp"
#include "simulation/report/bus_log.hpp"
#include "simulation/report/page.hpp"
#include "simulation/world.hpp"

namespace simulation::report {

// "not driving because: remote inhibit, awaiting neutral"
std::string tell_inhibits(spm::Inhibits inhibits);
// "faults: remote silent"
std::string tell_faults(spm::FaultSet faults);

class InsideLog : public Observer {
 public:
  // All must outlive it.
  InsideLog(World& world, Page& page, BusLog& log);

  void on_sample(const Sample& sample) override;

 private:
  void tell(const std::string& sentence, Time at);

  const InsideView* view_;  // null: nobody looks in
  Page& page_;
  BusLog& log_;
  std::optional<Inside> before_;
};

}  // namespace simulation::report
