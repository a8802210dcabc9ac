// The remote's clock against the power module's, far beyond what the document allows.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "simulation/board/avr_board.hpp"
#include "simulation/board/host_board.hpp"
#include "simulation/monitor/monitor.hpp"
#include "simulation/world.hpp"

namespace simulation {
namespace {

constexpr double nominal_bit_us = 1e6 / 38400;

struct Outcome {
  int answers = 0;
  int bad = 0;            // that the remote could not read
  double speed = 0;       // m/s, driving
  Time let_go_to_rest{};  // from the stick in neutral to engaged brakes; 0 if it did not drive
  Time cut_to_rest{};     // from a cut cable
  std::string breach;     // of a clause of the monitor
};

// Both ends of a link, one `share` faster than the other; drive, let go, drive, cut the cable.
class Trial {
 public:
  Trial(std::unique_ptr<SpmBoard> board, double share) : world_(std::move(board)) {
    world_.observe(monitor_);
    world_.remote().timing.bit_us = nominal_bit_us / (1 + share);
  }
  Outcome run() {
    Outcome outcome;
    world_.remote().start(world_.now());
    world_.run_for(1500ms);
    drive();
    outcome.speed = world_.chair().state().speed;
    outcome.let_go_to_rest = until_at_rest([this] { world_.remote().controls.speed = 512; });
    world_.run_for(500ms);
    drive();
    outcome.answers = world_.remote().statistics().answers;
    outcome.bad = world_.remote().statistics().bad;
    outcome.cut_to_rest = until_at_rest([this] { world_.wire().cut(world_.now()); });
    for (const auto& breach : monitor_.breaches()) {
      outcome.breach += std::string(breach.clause->id) + ": " + breach.seen + "\n";
    }
    return outcome;
  }

 private:
  bool is_moving() {
    const Pins pins = world_.board().pins();
    return pins.left_duty != 0 || pins.right_duty != 0 || pins.left_brake_release || pins.right_brake_release;
  }
  void drive() {
    world_.remote().controls.speed = 900;
    world_.run_for(2s);
  }
  template <typename Act>
  Time until_at_rest(Act act) {
    act();
    const Time begin = world_.now();
    while (is_moving() && world_.now() - begin < 10s) {
      world_.run_for(1ms);
    }
    return world_.now() - begin;
  }

  World world_;
  // A power module that understands nothing gives up after 5 s by its own clock.
  monitor::Monitor monitor_{{"H-16.2"}};
};

void judge(double percent, const Outcome& outcome, const Outcome& even) {
  INFO(percent << " %: " << outcome.answers << " answers, " << outcome.bad << " bad, " << outcome.speed << " m/s, "
               << outcome.let_go_to_rest / 1ms << " ms, " << outcome.cut_to_rest / 1ms << " ms");
  INFO(outcome.breach);
  CHECK(outcome.breach.empty());
  CHECK(outcome.let_go_to_rest <= 2 * even.let_go_to_rest);
  CHECK(outcome.cut_to_rest <= 2 * even.cut_to_rest);
  CHECK(outcome.speed >= 0);
  CHECK(outcome.speed <= even.speed * 1.06);  // it is still speeding up, by a clock that may be fast
  if (std::abs(percent) <= 2) {
    CHECK(std::abs(outcome.answers - even.answers) <= 2);  // of 354
    CHECK(outcome.bad == 0);
    CHECK(outcome.speed == Approx(even.speed).epsilon(0.03));
    CHECK(outcome.let_go_to_rest - even.let_go_to_rest < 40ms);
    CHECK(outcome.cut_to_rest - even.cut_to_rest < 25ms);
  }
}

}  // namespace

TEST_CASE("the remote's clock may be 2 % off; beyond, the chair drives as told or not at all", "[H-24][SB-2.1]") {
  const Outcome even = Trial(make_host_board(), 0).run();
  REQUIRE(even.speed > 0.6);
  REQUIRE(even.answers > 200);
  int driving = 0;
  for (int step = -20; step <= 20; ++step) {
    const Outcome outcome = Trial(make_host_board(), step * 0.005).run();
    judge(step * 0.5, outcome, even);
    driving += outcome.speed > 0.3 ? 1 : 0;
  }
  CHECK(driving >= 9);
  CHECK(driving < 41);  // or nothing was swept
  std::printf("clock drift: the chair drives at %d of 41 points from -10 %% to +10 %%\n", driving);
}

TEST_CASE("the chip's own crystal may be off as well", "[H-24][SB-2.1]") {
  const auto board = [](double percent) {
    return make_avr_board({.image = std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf",
                           .clock_error_ppm = static_cast<std::int32_t>(percent * 10000)});
  };
  const Outcome even = Trial(board(0), 0).run();
  REQUIRE(even.speed > 0.6);
  for (const double percent : {-10.0, -4.0, -2.0, 2.0, 4.0, 10.0}) {
    judge(percent, Trial(board(percent), 0).run(), even);
  }
}

}  // namespace simulation
