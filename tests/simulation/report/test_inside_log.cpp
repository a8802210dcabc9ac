// What the power module thinks, among the lines of the bus.
#include "simulation/report/inside_log.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "simulation/board/host_board.hpp"

namespace simulation::report {

using Catch::Contains;

TEST_CASE("reasons not to drive and faults are told in words") {
  using spm::Inhibit;
  using spm::Inhibits;
  CHECK(tell_inhibits(Inhibits::of(Inhibit::awaiting_neutral) | Inhibits::of(Inhibit::remote_inhibit)) ==
        "not driving because: remote inhibit, awaiting neutral");
  CHECK(tell_inhibits({}) == "nothing forbids driving");
  CHECK(tell_faults(spm::FaultSet::of(spm::Fault::general_missing)) == "faults: remote silent");
  CHECK(tell_faults({}) == "no fault any more");
}

TEST_CASE("changes of the set are told once each, from inside, with the bus only") {
  World world(make_host_board());
  std::ostringstream with_bus;
  std::ostringstream without;
  Page page;
  page.add_reader(with_bus, Palette(), true);
  page.add_reader(without, Palette(), false);
  BusLog log(page);
  InsideLog inside(world, page, log);
  world.observe(log);
  world.observe(inside);
  world.remote().start(world.now());
  world.run_for(1s);
  world.remote().controls.remote_inhibit = true;
  world.run_for(1s);
  world.remote().is_silent = true;
  world.run_for(200ms);
  page.finish();
  CHECK_THAT(with_bus.str(), Contains("[inside] not driving because: no general from the remote yet"));
  CHECK_THAT(with_bus.str(), Contains("[inside] nothing forbids driving"));
  CHECK_THAT(with_bus.str(), Contains("[inside] not driving because: remote inhibit, awaiting neutral\n"));
  CHECK_THAT(with_bus.str(), Contains("[inside] faults: remote silent"));
  const std::string text = with_bus.str();
  const std::string once = "nothing forbids driving";
  CHECK(text.find(once) == text.rfind(once));
  CHECK_THAT(without.str(), !Contains("[inside]"));
}

}  // namespace simulation::report
