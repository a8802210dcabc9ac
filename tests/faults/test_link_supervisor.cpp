#include "faults/link_supervisor.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace base;
using faults::LinkSupervisor;

// A watched link and one clock in microseconds behind both of its scales.
struct Watch {
  LinkSupervisor link{LinkSupervisor::Limits{3, 61250_us, 5}};
  std::uint64_t now = 7000000;

  Instant instant() const { return Instant(static_cast<std::uint32_t>(now / 1000)); }
  Stamp stamp() const { return Stamp(static_cast<std::uint16_t>(now)); }
  void message() { link.message(instant(), stamp()); }
  void pass(std::uint64_t span) {
    for (const std::uint64_t end = now + span; now < end;) {
      now += 250;
      link.poll(instant(), stamp());
    }
  }
};

TEST_CASE("a new link is up, and nobody is missed before the first message", "[SB-2.15]") {
  Watch watch;
  watch.pass(10000000);
  CHECK(watch.link.is_up());
  CHECK_FALSE(watch.link.is_silent());
}

TEST_CASE("the third corrupt packet in a row loses the link, the second does not", "[SB-2.14][H-05]") {
  Watch watch;
  watch.message();
  watch.link.corrupt();
  watch.link.corrupt();
  CHECK(watch.link.is_up());
  CHECK_FALSE(watch.link.has_corrupt_run());
  watch.link.corrupt();
  CHECK(watch.link.has_corrupt_run());
  CHECK_FALSE(watch.link.is_up());
}

TEST_CASE("any sound packet ends a run of corrupt ones", "[SB-2.14][H-05]") {
  Watch watch;
  watch.message();
  for (int i = 0; i < 100; ++i) {
    watch.link.corrupt();
    watch.link.corrupt();
    if (i % 2 == 0) {
      watch.link.sound();
    } else {
      watch.message();
    }
  }
  CHECK(watch.link.is_up());
}

TEST_CASE("a run of corrupt packets of any length ends with one sound packet", "[SB-2.14]") {
  Watch watch;
  for (int i = 0; i < 1000; ++i) {  // longer than a byte can count
    watch.link.corrupt();
  }
  CHECK(watch.link.has_corrupt_run());
  watch.link.sound();
  CHECK_FALSE(watch.link.has_corrupt_run());
  CHECK_FALSE(watch.link.is_up());
}

TEST_CASE("five good messages in a row bring a lost link back, four do not", "[SB-2.16][H-08]") {
  Watch watch;
  watch.message();
  for (int i = 0; i < 3; ++i) {
    watch.link.corrupt();
  }
  for (int i = 0; i < 4; ++i) {
    watch.message();
    CHECK_FALSE(watch.link.is_up());
  }
  watch.message();
  CHECK(watch.link.is_up());
}

TEST_CASE("a corrupt packet among the five starts the proof over", "[SB-2.16][H-06]") {
  Watch watch;
  watch.link.restarted();
  for (int i = 0; i < 4; ++i) {
    watch.message();
  }
  watch.link.corrupt();
  for (int i = 0; i < 4; ++i) {
    watch.message();
    CHECK_FALSE(watch.link.is_up());
  }
  watch.message();
  CHECK(watch.link.is_up());
}

TEST_CASE("other sound packets prove nothing", "[SB-2.16]") {
  Watch watch;
  watch.link.restarted();
  for (int i = 0; i < 20; ++i) {
    watch.link.sound();
  }
  CHECK_FALSE(watch.link.is_up());
}

TEST_CASE("silence loses the link 61.25 ms after the last message, wherever in the clocks' cycles that falls",
          "[SB-2.15][H-04]") {
  for (std::uint64_t start = 7000000; start < 7140000; start += 777) {
    Watch watch;
    watch.now = start;
    watch.message();
    watch.pass(61000);
    CAPTURE(start);
    CHECK(watch.link.is_up());
    watch.pass(500);
    CHECK_FALSE(watch.link.is_up());
    CHECK(watch.link.is_silent());
  }
}

TEST_CASE("a link that is asked too late still knows that it is lost", "[SB-2.15]") {
  for (std::uint64_t late = 61250; late < 400000; late += 333) {
    Watch watch;
    watch.message();
    watch.now += late;
    watch.link.poll(watch.instant(), watch.stamp());
    CAPTURE(late);
    CHECK(watch.link.is_silent());
  }
}

TEST_CASE("a silent link stays silent until the next message and lost until it has proved itself", "[SB-2.16]") {
  Watch watch;
  watch.message();
  watch.pass(200000);  // three wraps of the fine clock
  CHECK(watch.link.is_silent());
  watch.link.sound();
  CHECK(watch.link.is_silent());
  watch.message();
  CHECK_FALSE(watch.link.is_silent());
  CHECK_FALSE(watch.link.is_up());
}

TEST_CASE("a pause among the five starts the proof over", "[SB-2.16]") {
  Watch watch;
  watch.link.restarted();
  for (int i = 0; i < 4; ++i) {
    watch.message();
    watch.pass(20000);
  }
  watch.pass(50000);
  for (int i = 0; i < 4; ++i) {
    watch.message();
    watch.pass(20000);
  }
  CHECK_FALSE(watch.link.is_up());
}

TEST_CASE("a peer that starts over is lost, and its silence is not counted until it speaks", "[SB-3.4][SB-2.15]") {
  Watch watch;
  watch.message();
  watch.link.restarted();
  CHECK_FALSE(watch.link.is_up());
  watch.pass(1000000);
  CHECK_FALSE(watch.link.is_silent());
  watch.message();
  watch.pass(62000);
  CHECK(watch.link.is_silent());
}

TEST_CASE("a peer that starts over begins with a clean count of corrupt packets", "[SB-3.4][SB-2.14]") {
  Watch watch;
  watch.message();
  watch.link.corrupt();
  watch.link.corrupt();
  watch.link.restarted();
  watch.link.corrupt();
  watch.link.corrupt();
  CHECK_FALSE(watch.link.has_corrupt_run());
}

TEST_CASE("at rest silence is expected", "[SB-2.15]") {
  Watch watch;
  watch.message();
  watch.link.rest();
  watch.pass(1000000);
  CHECK(watch.link.is_up());
  CHECK_FALSE(watch.link.is_silent());
}

}  // namespace
