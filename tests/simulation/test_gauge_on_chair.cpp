// The gauge on the simulated chair: what it says of the battery's model while it is driven (SB-01.1, H-26).
#include <catch2/catch.hpp>
#include <cstdlib>

#include "simulation/models/chair.hpp"
#include "spm/battery.hpp"
#include "spm/fuel_gauge.hpp"

namespace {

using namespace spm;
using namespace std::chrono_literals;

struct Rig {
  Battery battery;
  Inputs in;
  Outputs out;
  Settings settings;
};

void pass(Rig& rig, FuelGauge& gauge, simulation::Chair& chair, int duty, int milliseconds, std::uint32_t& now) {
  simulation::Pins pins;
  pins.bridge_enable = pins.motor_relay = duty != 0;
  pins.left_brake_release = pins.right_brake_release = duty != 0;
  pins.left_forward = pins.right_forward = true;
  pins.left_duty = pins.right_duty = static_cast<std::uint16_t>(duty * 511 / 16384);
  rig.out.left = rig.out.right = Demand(static_cast<std::int16_t>(duty));
  rig.out.left_brake = rig.out.right_brake = duty != 0 ? Brake::released : Brake::engaged;
  chair.apply(pins);
  for (int i = 0; i < milliseconds; ++i, ++now) {
    chair.step(1ms);
    if (now % 10 == 0) {
      const auto volts = chair.analog_volts();
      const auto raw = [&](std::size_t channel) { return static_cast<int>(volts[channel] * 1024 / 5); };
      rig.in.left_current = base::Milliamps((raw(1) - 512) * 244);
      rig.in.right_current = base::Milliamps((raw(2) - 512) * 244);
      rig.in.brake_coils = base::Milliamps(raw(3) * 5);
      rig.in.battery = base::Millivolts(static_cast<std::uint16_t>(raw(0) * 40000 / 1024));
      rig.in.analog_ready = true;
      rig.battery.step(rig.in, rig.out, rig.settings, FaultSet());
      gauge.step(rig.battery.at_rest(), rig.settings, base::Instant(now));
    }
  }
}

TEST_CASE("after a long drive uphill the gauge shows what it shows after a rest, within a step, and it has moved",
          "[SB-01.1][H-26]") {
  Rig rig;
  FuelGauge gauge;
  simulation::Chair chair;
  std::uint32_t now = 0;
  gauge.start(base::Instant(now));
  pass(rig, gauge, chair, 0, 2000, now);
  CHECK(gauge.value() == 18);
  chair.set_slope(6);
  pass(rig, gauge, chair, 15000, 3600 * 1000, now);  // an hour
  const int driving = gauge.value();
  CHECK(driving < 15);
  pass(rig, gauge, chair, 0, 120 * 1000, now);
  CHECK(gauge.value() >= driving);
  CHECK(gauge.value() <= driving + 1);
  FuelGauge fresh;
  fresh.start(base::Instant(now));
  pass(rig, fresh, chair, 0, 60 * 1000, now);
  CHECK(std::abs(fresh.value() - driving) <= 1);
}

}  // namespace
