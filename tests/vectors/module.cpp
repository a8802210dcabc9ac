// spm: the whole power module, through a morning with everything in it and through worse.
#include "tests/vectors/groups.hpp"
#include "tests/vectors/module_bench.hpp"
#include "tests/vectors/settings.hpp"

namespace vectors {

using namespace base;        // literals
using namespace bus::shark;  // names of the wire

namespace {

General deflected(uint8_t speed, uint8_t direction) {
  General general;
  general.speed = speed;
  general.direction = direction;
  return general;
}

const General neutral;

// Section 3: silent until the remote's power-up packet, which gets ours.
void start_up(Record& record, ModuleBench& bench) {
  bench.inputs().wake = true;
  bench.wait(20);
  bench.inputs().wake = false;
  bench.wait(20);
  record.known(static_cast<uint8_t>(bench.spm().phase()), 0);
  bench.power_up();
  record.known(bench.said(0), 0x05);
  record.known(bench.said(2), 0xFA);
  record.known(bench.said(3), 0x0F);
  bench.generals(neutral, 8);
  record.known(bench.spm().inhibits().bits(), 0);
  record.known(bench.said(0), 0x61);
}

void drive(Record& record, ModuleBench& bench) {
  bench.generals(deflected(0x7F, 0x40), 40);
  record.known(bench.outputs().left.count(), 16384);
  bench.generals(deflected(0x7F, 0x7F), 20);
  record.known(bench.outputs().right.count(), 4916);
  bench.generals(deflected(0x20, 0x40), 40);
}

// SB-2.15 to SB-2.17, then back in LIMP, which caps at 0.4 of all.
void lose_link(Record& record, ModuleBench& bench) {
  bench.generals(deflected(0x7F, 0x40), 40);
  bench.wait(400);
  record.known(bench.spm().faults().is_limping, 1);
  bench.generals(deflected(0x7F, 0x40), 60);
  record.known(bench.outputs().left.count(), 0);
  bench.generals(neutral, 8);
  bench.generals(deflected(0x00, 0x40), 40);
  record.known(bench.outputs().left.count(), -6554);
}

void meet_other_faults(Record& record, ModuleBench& bench) {
  General corrupt = deflected(0x7F, 0x40);
  corrupt.spoiled = 1;
  bench.generals(corrupt, 5);
  bench.generals(neutral, 60);
  record.known(static_cast<uint8_t>(bench.outputs().left_brake), 0);
  bench.inputs().battery = 17000_mV;
  bench.generals(deflected(0x60, 0x30), 120);
  record.known(bench.spm().active_faults().has(spm::Fault::battery_flat), 1);
  bench.inputs().battery = 24000_mV;
  bench.power_up();
  record.known(static_cast<uint8_t>(bench.spm().phase()), 1);
  bench.generals(neutral, 8);
}

// SB-4.1 to SB-4.5.
void power_down(Record& record, ModuleBench& bench) {
  General pressed;
  pressed.switches = 0x04;
  bench.generals(pressed, 5);
  bench.generals(neutral, 2);
  record.known((bench.said(2) & 0x10) != 0, 1);  // power down now
  General confirmed;
  confirmed.answers = 0x01;
  bench.generals(confirmed, 3);
  bench.wait(100);
  record.known(static_cast<uint8_t>(bench.outputs().latch), 2);
}

// Any packet that could come, and much that should not.
void say_anything(ModuleBench& bench, Random& random) {
  const Type types[] = {Type::sr_general,   Type::sr_general,   Type::sr_general,   Type::sr_power_up,
                        Type::factory_test, Type::sacu_general, Type::spm_settings, Type::joystick_calibration,
                        Type::sr_hhp_data,  Type::sacu_power_up};
  const Type type = random.any_of(types);
  const uint8_t length = static_cast<uint8_t>(1 + random.below(8));
  uint8_t data[longest_data];
  for (uint8_t& byte : data) {
    byte = random.byte() & 0x7F;
  }
  bench.say(type, data, length, random.one_in(16));
}

void disturb(ModuleBench& bench, Random& random) {
  const uint32_t pauses[] = {2, 5, 6, 65, 255, 256, 400, 65536, 5000, 900000};
  spm::Inputs& in = bench.inputs();
  switch (random.below(8)) {
    case 0:
      bench.stand_still(random.any_of(pauses));
      break;
    case 1:
      in.battery = Millivolts(random.word());
      break;
    case 2:
      in.wake = random.one_in(4);
      break;
    case 3:
      in.echo_differed = random.one_in(4);
      break;
    case 4:
      for (uint8_t i = 0; i < 8; ++i) {
        const uint8_t byte = random.byte();
        bench.hear(byte, random.one_in(8));
      }
      break;
    default:
      say_anything(bench, random);
      break;
  }
}

}  // namespace

void whole_module(Record& record) {
  spm::Settings settings;
  settings.set(spm::Setting::acceleration, 2000);
  settings.set(spm::Setting::forward_deceleration, 2000);
  settings.set(spm::Setting::reverse_deceleration, 2000);
  settings.set(spm::Setting::turn_acceleration, 2000);
  ModuleBench bench(record, settings);
  start_up(record, bench);
  drive(record, bench);
  lose_link(record, bench);
  meet_other_faults(record, bench);
  power_down(record, bench);
}

// SB-4.2: two minutes, in strides just too short for the remote to count as gone.
void sleepy_module(Record& record) {
  spm::Settings settings;
  settings.set(spm::Setting::sleep_timeout, 2);
  ModuleBench bench(record, settings);
  bench.power_up();
  for (uint8_t i = 0; i < 29; ++i) {
    bench.stand_still(4000);
    bench.generals(neutral, 1);
  }
  record.known(bench.said(3) & 0x08, 0);
  bench.stand_still(4000);
  bench.generals(neutral, 1);
  record.known(bench.said(3) & 0x08, 0x08);
}

void rough_module(Record& record) {
  Random random(16);
  for (uint8_t i = 0; i < 4; ++i) {
    ModuleBench bench(record, any_extremes(random));
    bench.power_up();
    for (uint8_t j = 0; j < 20; ++j) {
      bench.generals(neutral, static_cast<uint8_t>(random.below(8)));
      const uint8_t speed = random.byte() & 0x7F;
      const uint8_t direction = random.byte() & 0x7F;
      bench.generals(deflected(speed, direction), static_cast<uint8_t>(random.below(24)));
      disturb(bench, random);
    }
    bench.wait(3600);  // SB-2.17: silence stops it whatever went before
    record.known(bench.outputs().left.count(), 0);
    record.known(static_cast<uint8_t>(bench.outputs().right_brake), 0);
    record.add(bench.spm().events().total());
    record.add(bench.spm().events().newest(0).code);
  }
}

}  // namespace vectors
