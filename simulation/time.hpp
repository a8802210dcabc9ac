// Simulated time: nanoseconds since the run began. Nothing in the simulation reads a wall clock.
#pragma once

#include <chrono>
#include <cstdint>

namespace simulation {

using Time = std::chrono::duration<std::int64_t, std::nano>;
using namespace std::chrono_literals;

constexpr double seconds(Time time) {
  return static_cast<double>(time.count()) * 1e-9;
}
constexpr double milliseconds(Time time) {
  return static_cast<double>(time.count()) * 1e-6;
}

}  // namespace simulation
