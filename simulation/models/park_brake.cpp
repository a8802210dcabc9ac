#include "simulation/models/park_brake.hpp"

namespace simulation {
namespace {

constexpr Time release_time = 60ms;
constexpr Time engage_time = 40ms;

}  // namespace

void ParkBrake::step(bool is_coil_on, Time dt) {
  if (is_coil_on != is_engaged_) {
    against_ = {};
    return;
  }
  against_ += dt;
  if (against_ >= (is_engaged_ ? release_time : engage_time)) {
    is_engaged_ = !is_engaged_;
    against_ = {};
  }
}

}  // namespace simulation
