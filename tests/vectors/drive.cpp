// spm: from the stick to the wheels.
#include "spm/drive.hpp"

#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"
#include "tests/vectors/settings.hpp"

namespace vectors {

using bus::shark::JoystickReading;
using bus::shark::PotReading;
using spm::Command;
using spm::Demand;
using spm::DriveProfile;
using spm::Setting;
using spm::Settings;
using spm::Stick;
using spm::Wheels;

namespace {

// Both ends, neutral, and each side of the edges that the default deadband (30) and travel (475) make.
const uint16_t edges[] = {0,   1,   36,  37,  38,  255, 256, 481, 482, 483,  511,
                          512, 513, 541, 542, 543, 768, 986, 987, 988, 1022, 1023};

Stick stick_at(uint16_t speed, uint16_t direction, uint8_t pot) {
  Stick stick;
  stick.speed = JoystickReading(speed);
  stick.direction = JoystickReading(direction);
  stick.pot = PotReading(pot);
  return stick;
}

Wheels both(int16_t demand) {
  return Wheels{Demand(demand), Demand(demand)};
}

Demand any_demand(Random& random) {
  return Demand(static_cast<int16_t>(random.below(32769) - 16384L));
}

void add_wheels(Record& record, const Wheels& wheels) {
  // In one word: 32 bits hold both.
  record.add((static_cast<uint32_t>(static_cast<uint16_t>(wheels.left.count())) << 16) |
             static_cast<uint16_t>(wheels.right.count()));
}

Command command(int16_t forward, int16_t turn) {
  Command made;
  made.forward = forward;
  made.turn = turn;
  return made;
}

Wheels targets_of(const Stick& stick, const DriveProfile& profile, bool is_limping) {
  return mix(command_of(stick, profile, is_limping));
}

void add_targets(Record& record, const Stick& stick, const DriveProfile& profile) {
  record.add(is_at_rest(stick, profile));
  add_wheels(record, targets_of(stick, profile, false));
  add_wheels(record, targets_of(stick, profile, true));
}

void know_wheels(Record& record, const Wheels& wheels, int16_t left, int16_t right) {
  record.known(wheels.left.count(), left);
  record.known(wheels.right.count(), right);
}

void add_profile(Record& record, const DriveProfile& profile) {
  record.add(profile.deadband);
  record.add(profile.travel);
  record.add(profile.axis_gain);
  record.add(profile.pot_floor);
  record.add(profile.forward_maximum);
  record.add(profile.reverse_maximum);
  record.add(profile.turn_maximum);
  record.add(profile.limp_maximum);
  record.add(profile.speedo_gain);
  record.add(profile.acceleration);
  record.add(profile.forward_deceleration);
  record.add(profile.reverse_deceleration);
  record.add(profile.turn_acceleration);
  record.add(profile.turn_deceleration);
  record.add(profile.emergency_deceleration);
}

void step_often(spm::Ramps& ramps, const Command& command, const DriveProfile& profile, uint16_t times) {
  ramps.aim_at(command);
  for (uint16_t i = 0; i < times; ++i) {
    ramps.step(profile);
  }
}

void stop_often(spm::Ramps& ramps, const DriveProfile& profile, uint16_t times) {
  for (uint16_t i = 0; i < times; ++i) {
    ramps.stop(profile);
  }
}

}  // namespace

void profiles(Record& record) {
  // All settings wander through their ranges together, each at its own length: every value is met.
  for (uint16_t i = 0; i <= 1980; ++i) {
    Settings settings;
    for (uint8_t j = 0; j <= static_cast<uint8_t>(Setting::emergency_deceleration); ++j) {
      const Setting setting = static_cast<Setting>(j);
      const spm::SettingRange range = spm::range_of(setting);
      settings.set(setting, static_cast<uint16_t>(range.least + i % (range.most - range.least + 1U)));
    }
    add_profile(record, make_profile(settings));
  }
  Random random(10);
  for (uint16_t i = 0; i < 300; ++i) {
    add_profile(record, make_profile(any_extremes(random)));
  }

  const DriveProfile shipped = make_profile(Settings());
  record.known(shipped.travel, 445);
  record.known(shipped.axis_gain, 589);   // 16384 * 16 / 445 = 589.09
  record.known(shipped.pot_floor, 3604);  // 0.22 * 16384 = 3604.48
  record.known(shipped.forward_maximum, 16384);
  record.known(shipped.turn_maximum, 5734);  // 0.35 * 16384 = 5734.4
  record.known(shipped.limp_maximum, 6554);  // 0.4 * 16384 = 6553.6
  record.known(shipped.speedo_gain, 248);    // 31 * 2^17 / 16384
  // 2^14 * 256 / 10^6 = 4.194304 for each permille a second.
  record.known(shipped.acceleration, 608);             // 608.2
  record.known(shipped.forward_deceleration, 2013);    // 2013.3
  record.known(shipped.reverse_deceleration, 1342);    // 1342.2
  record.known(shipped.turn_acceleration, 1468);       // 1468.0
  record.known(shipped.turn_deceleration, 2517);       // 2516.6
  record.known(shipped.emergency_deceleration, 3355);  // 3355.4
  Settings slow;
  slow.set(Setting::forward_maximum, 100);
  slow.set(Setting::acceleration, 2000);
  slow.set(Setting::deadband, 100);
  slow.set(Setting::stick_travel, 200);
  record.known(make_profile(slow).speedo_gain, 2480);   // 31 * 2^17 / 1638 = 2480.6
  record.known(make_profile(slow).acceleration, 8389);  // 8388.6
  record.known(make_profile(slow).axis_gain, 2621);     // 16384 * 16 / 100
}

void targets(Record& record) {
  const DriveProfile profile = make_profile(Settings());
  const uint16_t speeds[] = {0, 37, 128, 256, 481, 482, 512, 543, 600, 768, 900, 986, 1023};
  const uint16_t directions[] = {0, 200, 400, 481, 512, 543, 560, 800, 1023};
  for (uint16_t pot = 0; pot <= 255; ++pot) {
    for (const uint16_t speed : speeds) {
      for (const uint16_t direction : directions) {
        add_targets(record, stick_at(speed, direction, static_cast<uint8_t>(pot)), profile);
      }
    }
  }
  for (uint16_t reading = 0; reading <= 1023; ++reading) {
    add_targets(record, stick_at(reading, 512, 255), profile);
    add_targets(record, stick_at(512, reading, 255), profile);
    add_targets(record, stick_at(reading, static_cast<uint16_t>(1023 - reading), 100), profile);
  }

  for (uint16_t speed = 0; speed <= 1023; speed = static_cast<uint16_t>(speed + 7)) {
    for (uint16_t direction = 0; direction <= 1023; direction = static_cast<uint16_t>(direction + 5)) {
      add_targets(record, stick_at(speed, direction, 200), profile);
    }
  }

  know_wheels(record, targets_of(stick_at(512, 512, 255), profile, false), 0, 0);
  know_wheels(record, targets_of(stick_at(542, 482, 255), profile, false), 0, 0);    // the deadband's edges
  know_wheels(record, targets_of(stick_at(543, 512, 255), profile, false), 36, 36);  // 589 / 16
  know_wheels(record, targets_of(stick_at(1023, 512, 255), profile, false), 16384, 16384);
  know_wheels(record, targets_of(stick_at(0, 512, 255), profile, false), -16384, -16384);
  know_wheels(record, targets_of(stick_at(1023, 512, 0), profile, false), 3604, 3604);
  know_wheels(record, targets_of(stick_at(1023, 512, 128), profile, false), 10019, 10019);  // 3604 + 12780 * 128/255
  know_wheels(record, targets_of(stick_at(512, 1023, 255), profile, false), 5734, -5734);
  know_wheels(record, targets_of(stick_at(1023, 1023, 255), profile, false), 16384, 4916);  // 16384 - 2 * 5734
  know_wheels(record, targets_of(stick_at(0, 512, 255), profile, true), -6554, -6554);
}

void targets_at_extremes(Record& record) {
  const uint8_t pots[] = {0, 1, 127, 128, 254, 255};
  Random random(11);
  for (uint8_t i = 0; i < 200; ++i) {
    const DriveProfile profile = make_profile(any_extremes(random));
    for (const uint16_t edge : edges) {
      const uint16_t other = random.any_of(edges);
      const uint8_t pot = random.any_of(pots);
      add_targets(record, stick_at(edge, other, pot), profile);
      add_targets(record, stick_at(other, edge, pot), profile);
    }
    // The edges of this profile's own deadband and travel.
    for (int8_t beside = -1; beside <= 1; ++beside) {
      const uint16_t rest = static_cast<uint16_t>(512 + profile.deadband + beside);
      const uint16_t full = static_cast<uint16_t>(512 - profile.deadband - profile.travel + beside);
      add_targets(record, stick_at(rest, full, 255), profile);
      add_targets(record, stick_at(full, rest, 255), profile);
    }
  }
  Settings least;
  least.set(Setting::deadband, 10);
  least.set(Setting::forward_maximum, 100);
  least.set(Setting::pot_floor, 50);
  know_wheels(record, targets_of(stick_at(1023, 512, 0), make_profile(least), false), 81, 81);  // 1638 * 819 / 16384
  Settings most;
  most.set(Setting::turn_maximum, 1000);
  most.set(Setting::pot_floor, 1000);
  know_wheels(record, targets_of(stick_at(1023, 0, 0), make_profile(most), false), -16384, 16384);
}

void speedo(Record& record) {
  Settings slow;
  slow.set(Setting::forward_maximum, 100);
  const DriveProfile profiles[] = {make_profile(Settings()), make_profile(slow)};
  for (const DriveProfile& profile : profiles) {
    for (int16_t demand = -16384; demand < 16384; demand = static_cast<int16_t>(demand + 16)) {
      record.add(speedo_of(both(demand), profile));
      record.add(speedo_of(both(static_cast<int16_t>(demand + 1)), profile));
    }
    Random random(12);
    for (uint16_t i = 0; i < 1000; ++i) {
      const Demand left = any_demand(random);
      const Demand right = any_demand(random);
      record.add(speedo_of(Wheels{left, right}, profile));
    }
  }

  record.known(speedo_of(both(16384), profiles[0]), 31);
  record.known(speedo_of(both(-16384), profiles[0]), 31);
  record.known(speedo_of(both(8192), profiles[0]), 16);  // 15.5, rounded up
  record.known(speedo_of(both(264), profiles[0]), 0);    // 0.4995
  record.known(speedo_of(both(265), profiles[0]), 1);    // 0.5014
  record.known(speedo_of(Wheels{Demand(16384), Demand(-16384)}, profiles[0]), 0);
  record.known(speedo_of(both(1638), profiles[1]), 31);
  record.known(speedo_of(both(16384), profiles[1]), 31);  // 310, but there is no more than 31
}

namespace {

// Any command whose sum fits, the ends above all.
Command any_command(Random& random) {
  const int16_t ends[] = {0, 1, -1, 8192, -8192, 16383, -16383, 16384, -16384};
  const int16_t turn = random.any_of(ends);
  const int16_t room = static_cast<int16_t>(16384 - (turn < 0 ? -turn : turn));
  const int16_t speeds[] = {0, room, static_cast<int16_t>(-room), static_cast<int16_t>(room / 2),
                            static_cast<int16_t>(room / -3)};
  return command(random.any_of(speeds), turn);
}

void wander(Record& record, Random& random) {
  const DriveProfile profile = make_profile(any_extremes(random));
  spm::Ramps ramps;
  bool is_stopping = false;
  for (uint16_t i = 0; i < 500; ++i) {
    if (random.one_in(64)) {
      ramps.aim_at(any_command(random));
      is_stopping = random.one_in(3);
    }
    if (is_stopping || random.one_in(32)) {
      ramps.stop(profile);
    } else {
      ramps.step(profile);
    }
    if (random.one_in(64)) {
      const Wheels asked = ramps.demand();
      const int16_t left = asked.left.count();
      ramps.yield_to(Wheels{Demand(static_cast<int16_t>(left - left / 3)), random.one_in(2) ? asked.right : Demand(0)});
    }
    add_wheels(record, ramps.demand());
  }
}

void know_speed_ramps(Record& record, const DriveProfile& shipped) {
  const Command ahead = command(16384, 0);
  spm::Ramps ramps;
  step_often(ramps, command(-16384, 0), shipped, 1);
  know_wheels(record, ramps.demand(), -2, -2);  // 608 / 256
  ramps.clear();
  step_often(ramps, ahead, shipped, 100);
  know_wheels(record, ramps.demand(), 237, 237);  // 60800 / 256
  step_often(ramps, ahead, shipped, 6798);
  know_wheels(record, ramps.demand(), 16382, 16382);  // 6898 * 608 / 256 = 16382.75
  step_often(ramps, ahead, shipped, 1);
  know_wheels(record, ramps.demand(), 16384, 16384);  // 16385 and 32/256
  step_often(ramps, command(-16384, 0), shipped, 1);
  know_wheels(record, ramps.demand(), 16377, 16377);  // less (2013 + 32) / 256 = 7 and 253/256
  step_often(ramps, ahead, shipped, 4);               // 3, 2 and 3 steps, then none; 29/256 are left over
  stop_often(ramps, shipped, 1250);
  know_wheels(record, ramps.demand(), 3, 3);  // 16384 - (1250 * 3355 + 29) / 256
  stop_often(ramps, shipped, 1);
  know_wheels(record, ramps.demand(), 0, 0);
}

void know_turn_ramps(Record& record, const DriveProfile& shipped) {
  spm::Ramps ramps;
  // The curve is 5734 / 10650 = 138 / 256. The speed goes to 2, 4, 7, 9, 11, 14 and 16; in the seventh millisecond the
  // first six steps of turn fit, as 14 * 138 / 256 = 7.
  step_often(ramps, command(10650, 5734), shipped, 6);
  know_wheels(record, ramps.demand(), 14, 14);
  step_often(ramps, command(10650, 5734), shipped, 1);
  know_wheels(record, ramps.demand(), 22, 10);
  ramps.clear();
  step_often(ramps, command(1000, 5734), shipped, 2);
  know_wheels(record, ramps.demand(), 15, -7);  // 1216 / 256 = 4 and 2936 / 256 = 11, which is less than 4 * 5.7
  ramps.clear();
  step_often(ramps, command(0, 5734), shipped, 100);
  know_wheels(record, ramps.demand(), 573, -573);  // 146800 / 256, 112/256 are left over
  stop_often(ramps, shipped, 1);
  know_wheels(record, ramps.demand(), 560, -560);  // less (3355 + 112) / 256
}

void know_stop_in_curve(Record& record, const DriveProfile& shipped) {
  spm::Ramps ramps;
  step_often(ramps, command(10000, 3000), shipped, 5000);  // 4211 * 608 / 256 = 10001 and 32/256
  know_wheels(record, ramps.demand(), 13000, 7000);
  stop_often(ramps, shipped, 100);                   // 10000 - (100 * 3355 + 32) / 256 = 8690, and 0.3 of it
  know_wheels(record, ramps.demand(), 11297, 6083);  // 8690 +- 2607
  stop_often(ramps, shipped, 663);
  know_wheels(record, ramps.demand(), 1, 1);  // 10000 - (763 * 3355 + 32) / 256
  step_often(ramps, command(10000, 3000), shipped, 5000);
  ramps.yield_to(Wheels{Demand(12990), Demand(6999)});  // 10 and 1 less: 5.5 of speed, 4.5 of turn, halves left over
  know_wheels(record, ramps.demand(), 12991, 6999);
}

}  // namespace

void ramps(Record& record) {
  Random random(13);
  for (uint8_t i = 0; i < 60; ++i) {
    wander(record, random);
  }
  know_speed_ramps(record, make_profile(Settings()));
}

void curves(Record& record) {
  Random random(15);
  for (uint8_t i = 0; i < 20; ++i) {
    wander(record, random);
  }
  const DriveProfile shipped = make_profile(Settings());
  know_turn_ramps(record, shipped);
  know_stop_in_curve(record, shipped);
}

}  // namespace vectors
