#include "faults/manager.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace faults;
using base::Instant;

enum class Fault : std::uint8_t { forever, cable, sticky_limp, passing, limping, slow };
using Faults = Set<Fault>;
constexpr std::uint8_t count = 6;

const Row rows[count] IN_FLASH = {
    {0, 0, Stops::until_power_down, Limps::no, 8, 1}, {1, 0, Stops::until_link, Limps::until_power_down, 9, 2},
    {2, 0, Stops::no, Limps::until_power_down, 7, 3}, {3, 0, Stops::while_present, Limps::no, 7, 4},
    {4, 0, Stops::no, Limps::while_present, 7, 5},    {5, 2000, Stops::while_present, Limps::no, 2, 6},
};

struct Table {
  Manager<Fault, count> manager;
  Faults present;
  bool is_link_up = true;
  std::uint32_t now = 0;

  Faults update(std::uint32_t after = 1) {
    now += after;
    return manager.update(rows, present, is_link_up, Instant(now));
  }
  Faults set(Fault fault, bool is_in = true) {
    present.put(fault, is_in);
    return update();
  }
};

TEST_CASE("without a fault nothing stops, limps or is shown") {
  Table table;
  table.update();
  CHECK_FALSE(table.manager.summary().must_stop);
  CHECK_FALSE(table.manager.summary().is_transient);
  CHECK_FALSE(table.manager.summary().is_limping);
  CHECK(table.manager.summary().system_state == 0);
  CHECK(table.manager.active().empty());
}

TEST_CASE("a fault that stops while present stops exactly that long") {
  Table table;
  CHECK(table.set(Fault::passing) == Faults::of(Fault::passing));
  CHECK(table.manager.summary().must_stop);
  CHECK_FALSE(table.manager.summary().is_transient);
  CHECK(table.manager.summary().system_state == 7);
  CHECK(table.manager.active() == Faults::of(Fault::passing));
  CHECK(table.set(Fault::passing, false).empty());
  CHECK_FALSE(table.manager.summary().must_stop);
  CHECK(table.manager.summary().system_state == 0);
}

TEST_CASE("a fault begins once, and again after it had ended") {
  Table table;
  CHECK(table.set(Fault::limping) == Faults::of(Fault::limping));
  CHECK(table.update().empty());
  CHECK(table.set(Fault::passing) == Faults::of(Fault::passing));
  table.set(Fault::limping, false);
  CHECK(table.set(Fault::limping) == Faults::of(Fault::limping));
}

TEST_CASE("TRANSIENT outlasts its cause until the link is up, LIMP outlasts that", "[SB-2.16][H-07][H-08]") {
  Table table;
  table.is_link_up = false;
  table.set(Fault::cable);
  CHECK(table.manager.summary().is_transient);
  CHECK(table.manager.summary().must_stop);
  CHECK(table.manager.summary().is_limping);

  table.set(Fault::cable, false);
  CHECK(table.manager.summary().is_transient);
  table.update(100000);
  CHECK(table.manager.summary().is_transient);

  table.is_link_up = true;
  table.update();
  CHECK_FALSE(table.manager.summary().is_transient);
  CHECK_FALSE(table.manager.summary().must_stop);
  CHECK(table.manager.summary().is_limping);
  CHECK(table.manager.summary().system_state == 9);  // what latched LIMP (SB-01.9)
  CHECK(table.manager.limping() == Faults::of(Fault::cable));
  CHECK(table.manager.stopping().empty());
  table.update(1000000);
  CHECK(table.manager.summary().is_limping);
}

TEST_CASE("TRANSIENT holds while its cause does, whatever the link says", "[SB-2.16]") {
  Table table;
  table.is_link_up = true;
  table.set(Fault::cable);
  CHECK(table.manager.summary().is_transient);
  table.update();
  CHECK(table.manager.summary().is_transient);
}

TEST_CASE("a link that goes down without the fault stops nothing by itself") {
  Table table;
  table.is_link_up = false;
  table.update();
  CHECK_FALSE(table.manager.summary().must_stop);
}

TEST_CASE("a stop until power-down never ends") {
  Table table;
  table.set(Fault::forever);
  table.set(Fault::forever, false);
  table.is_link_up = false;
  table.update();
  table.is_link_up = true;
  table.update(1000000);
  CHECK(table.manager.summary().must_stop);
  CHECK_FALSE(table.manager.summary().is_transient);
  CHECK(table.manager.stopping() == Faults::of(Fault::forever));
}

TEST_CASE("LIMP while present ends with its cause, latched LIMP does not", "[SB-00.6]") {
  Table table;
  table.set(Fault::limping);
  CHECK(table.manager.summary().is_limping);
  CHECK_FALSE(table.manager.summary().must_stop);
  table.set(Fault::limping, false);
  CHECK_FALSE(table.manager.summary().is_limping);
  table.set(Fault::sticky_limp);
  table.set(Fault::sticky_limp, false);
  CHECK(table.manager.summary().is_limping);
}

TEST_CASE("the earliest row in the table is what is shown", "[SB-01.9]") {
  Table table;
  table.present.add(Fault::passing);
  table.present.add(Fault::cable);
  table.present.add(Fault::forever);
  table.update();
  CHECK(table.manager.summary().system_state == 8);
  Table other;
  other.set(Fault::passing);
  CHECK(other.manager.summary().system_state == 7);
  other.set(Fault::cable);
  CHECK(other.manager.summary().system_state == 9);
}

TEST_CASE("a debounced fault counts once it has lasted its time, not a millisecond before") {
  Table table;
  CHECK(table.set(Fault::slow).empty());
  for (int i = 0; i < 1999; ++i) {
    REQUIRE(table.update().empty());
  }
  CHECK(table.manager.active().empty());
  CHECK(table.manager.summary().system_state == 0);
  CHECK(table.update() == Faults::of(Fault::slow));
  CHECK(table.manager.summary().must_stop);
  CHECK(table.manager.summary().system_state == 2);
  CHECK(table.update().empty());
}

TEST_CASE("a debounce starts over when its condition was gone for a moment") {
  Table table;
  table.set(Fault::slow);
  table.update(1990);
  table.set(Fault::slow, false);
  table.set(Fault::slow);
  table.update(1990);
  CHECK(table.manager.active().empty());
  table.update(10);
  CHECK(table.manager.active() == Faults::of(Fault::slow));
}

TEST_CASE("a debounce runs on across the wrap of the clock") {
  Table table;
  table.now = 0xFFFFFFFF - 1000;
  table.set(Fault::slow);
  table.update(1998);
  CHECK(table.manager.active().empty());
  table.update(2);
  CHECK(table.manager.active() == Faults::of(Fault::slow));
}

TEST_CASE("a second fault does not disturb a debounce that is running") {
  Table table;
  table.set(Fault::slow);
  table.update(1000);
  table.set(Fault::limping);
  table.set(Fault::limping, false);
  table.update(998);
  CHECK(table.manager.active() == Faults::of(Fault::slow));
}

}  // namespace
