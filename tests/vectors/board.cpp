// spm: readings into volts and amperes, demands into duty.
#include "spm/board.hpp"
#include "tests/vectors/drivers.hpp"
#include "tests/vectors/groups.hpp"

namespace vectors {

namespace {

spm::Inputs sensed(uint16_t raw) {
  measure(raw);
  spm::Board board;
  for (uint8_t i = 1; i < 5; ++i) {  // one reading each millisecond
    board.sense(base::Instant(i));
  }
  return board.sense(base::Instant(5));
}

const drivers::bridge::Motion& moved(int16_t demand) {
  spm::Outputs outputs;
  outputs.left = spm::Demand(demand);
  outputs.right = spm::Demand(static_cast<int16_t>(-demand));
  spm::Board().apply(outputs);
  return motion();
}

}  // namespace

void board(Record& record) {
  for (uint16_t raw = 0; raw <= 1023; ++raw) {
    const spm::Inputs in = sensed(raw);
    record.add(in.battery.count());
    record.add(static_cast<uint32_t>(in.left_current.count()));
    record.add(static_cast<uint32_t>(in.right_current.count()));
    record.add(static_cast<uint32_t>(in.brake_coils.count()));
  }
  for (int32_t demand = -16384; demand <= 16384; demand += 8) {
    const drivers::bridge::Motion& motion = moved(static_cast<int16_t>(demand));
    record.add(motion.left.duty);
    record.add(motion.left.is_forward);
    record.add(motion.right.duty);
    record.add(motion.right.is_forward);
  }

  record.known(sensed(1023).battery.count(), 39960);  // 1023/1024 of 40 V
  record.known(sensed(512).battery.count(), 20000);
  record.known(sensed(614).battery.count(), 23984);
  record.known(sensed(0).left_current.count(), -124928);  // 512 * 244
  record.known(sensed(1023).right_current.count(), 124684);
  record.known(sensed(128).brake_coils.count(), 625);
  record.known(sensed(512).brake_coils.count(), 2500);
  record.known(moved(16384).left.duty, 511);
  record.known(moved(16384).right.duty, 511);
  record.known(moved(16384).right.is_forward, 0);
  record.known(moved(8192).left.duty, 255);
  record.known(moved(31).left.duty, 0);  // a step of duty is 32 of demand
  record.known(moved(32).left.duty, 1);
}

}  // namespace vectors
