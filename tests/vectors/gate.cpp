// spm: the last gate, fed with sense and with nonsense.
#include "spm/drive_gate.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using base::Millis;
using spm::Demand;
using spm::DriveGate;
using spm::GateFacts;
using spm::Wheels;

namespace {

Demand any_demand(Random& random) {
  const int16_t ends[] = {0,     1,     -1,    8191,   8192,   8193,  -8192,  16383,
                          16384, 16385, 16400, -16384, -16385, 32767, -32767, INT16_MIN};
  return Demand(random.one_in(4) ? static_cast<int16_t>(random.word()) : random.any_of(ends));
}

GateFacts leave(bool may_drive, bool is_limping, uint32_t age) {
  GateFacts facts;
  facts.may_drive = may_drive;
  facts.allows_torque = true;
  facts.is_limping = is_limping;
  facts.general_age = Millis(age);
  return facts;
}

int16_t pass_often(DriveGate& gate, int16_t wanted, const GateFacts& facts, uint16_t times) {
  Wheels granted;
  for (uint16_t i = 0; i < times; ++i) {
    granted = gate.pass(Wheels{Demand(wanted), Demand(wanted)}, facts);
  }
  return granted.left.count();
}

}  // namespace

void drive_gate(Record& record) {
  const uint32_t ages[] = {0, 20, 66, 67, 32768, 65535, 65536, 65602, UINT32_MAX};
  Random random(14);
  for (uint8_t i = 0; i < 80; ++i) {
    DriveGate gate;
    GateFacts facts;
    Wheels wanted;
    for (uint16_t j = 0; j < 600; ++j) {
      if (random.one_in(48)) {
        facts.may_drive = !random.one_in(4);
        facts.is_limping = random.one_in(4);
        facts.general_age = Millis(random.one_in(3) ? random.any_of(ages) : 0U);
        facts.allows_torque = !random.one_in(8);
      }
      if (random.one_in(32)) {
        wanted.left = any_demand(random);
        wanted.right = any_demand(random);
      }
      if (gate.has_refused() && random.one_in(16)) {
        gate = DriveGate();
      }
      const Wheels granted = gate.pass(wanted, facts);
      record.add(granted.left.count());
      record.add(granted.right.count());
      record.add(gate.has_refused());
    }
  }

  DriveGate gate;
  record.known(pass_often(gate, 16384, leave(true, false, 66), 1), 66);
  record.known(pass_often(gate, 16384, leave(true, false, 66), 1), 132);
  record.known(pass_often(gate, 16384, leave(true, false, 67), 1), 120);
  record.known(pass_often(gate, 16384, leave(false, false, 0), 1), 108);
  record.known(pass_often(gate, -16384, leave(true, false, 0), 1), 0);
  record.known(pass_often(gate, -16384, leave(true, false, 0), 1), -66);
  record.known(pass_often(gate, -16384, leave(true, false, 0), 247), -16368);  // 248 * 66
  record.known(pass_often(gate, -16384, leave(true, false, 0), 1), -16384);
  record.known(pass_often(gate, -16384, leave(true, true, 0), 1), -16372);
  record.known(gate.has_refused(), 0);
  record.known(pass_often(gate, INT16_MIN, leave(true, false, 0), 1), -16360);
  record.known(gate.has_refused(), 1);
  record.known(pass_often(gate, -16384, leave(true, false, 0), 1), -16348);
  DriveGate limping;
  record.known(pass_often(limping, 16384, leave(true, true, 0), 124), 8184);
  record.known(pass_often(limping, 16384, leave(true, true, 0), 1), 8192);
  record.known(pass_often(limping, 16384, GateFacts(), 1), 0);

  DriveGate curve;
  record.known(pass_often(curve, 660, leave(true, false, 0), 10), 660);
  const Wheels slower{Demand(640), Demand(600)};
  record.known(curve.pass(slower, leave(false, false, 0)).right.count(), 600);
  record.known(curve.pass(slower, leave(false, false, 0)).left.count(), 628);
  record.known(curve.pass(slower, leave(false, false, 0)).right.count(), 600);
}

}  // namespace vectors
