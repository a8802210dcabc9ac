#include "simulation/bench/traffic.hpp"

#include <algorithm>
#include <cstddef>

namespace simulation::bench {
namespace {

constexpr Time start_up = 1s;
constexpr Time half = 500ms;
constexpr int turns_in_a_half = 25;
constexpr int characters_in_a_turn = 8;
constexpr int printable_characters = 94;

constexpr int neutral = RemoteControls{}.speed;
constexpr std::uint64_t halves_in_a_round = 20;

}  // namespace

void Traffic::start() {
  if (is_heavy_) {
    world_.attach_sacu();
  }
  world_.remote().start(world_.now());
  world_.run_for(start_up);
  if (is_heavy_) {
    world_.sacu().insists = !world_.sacu().is_acknowledged();
    world_.remote().sends_calibration = true;
    for (int i = 0; i < 4; ++i) {
      go_on();
    }
    world_.sacu().sends_calibration = true;
    go_on();
  }
}

void Traffic::go_on() {
  drive();
  if (is_heavy_) {
    type();
  }
  world_.run_for(half);
  ++halves_;
}

void Traffic::drain() {
  world_.remote().controls.speed = world_.remote().controls.direction = neutral;
  world_.run_for(start_up);
}

// Ten seconds: a while at rest, forward, a bend, forward, at rest.
void Traffic::drive() {
  RemoteControls& controls = world_.remote().controls;
  const std::uint64_t place = halves_ % halves_in_a_round;
  controls.speed = place >= 4 && place < 14 ? 800 : neutral;
  controls.direction = place >= 8 && place < 10 ? 600 : neutral;
}

// As many as the remote's turns can hold; the power module returns them all.
void Traffic::type() {
  std::string text;
  for (int i = 0; i < turns_in_a_half * characters_in_a_turn; ++i) {
    text += static_cast<char>('!' + (expected_.size() + text.size()) % printable_characters);
  }
  expected_ += text;
  world_.remote().programmer.type(text);
}

std::uint64_t Traffic::unreturned() const {
  const std::string& screen = world_.remote().programmer.screen();
  const std::size_t common = std::min(screen.size(), expected_.size());
  std::uint64_t wrong = std::max(screen.size(), expected_.size()) - common;
  for (std::size_t i = 0; i < common; ++i) {
    wrong += screen[i] != expected_[i] ? 1 : 0;
  }
  return wrong;
}

}  // namespace simulation::bench
