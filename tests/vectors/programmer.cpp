// spm/programmer: both streams, pushed and pulled at random.
#include "spm/programmer.hpp"

#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using namespace bus::shark;

namespace {

void hear_some(Record& record, spm::Programmer& programmer, Random& random) {
  HhpData data;
  data.count = static_cast<uint8_t>(1 + random.below(8));
  for (uint8_t& character : data.characters) {
    character = static_cast<uint8_t>(random.one_in(8) ? 0x0D : random.byte() & 0x7F);
  }
  record.add(programmer.hear(data));
  record.add(programmer.lost());
  record.add(programmer.is_losing());
}

void make_turn(Record& record, spm::Programmer& programmer, Random& random) {
  Turn turn;
  turn.open();
  programmer.add_to(turn, !random.one_in(4));
  turn.close();
  for (const uint8_t byte : turn.bytes()) {
    record.add(byte);
  }
}

}  // namespace

void programmer(Record& record) {
  Random random(18);
  spm::Programmer programmer;
  for (uint16_t i = 0; i < 4000; ++i) {
    switch (random.below(8)) {
      case 0:
        hear_some(record, programmer, random);
        break;
      case 1:
        record.add(programmer.put(static_cast<char>(random.byte())));
        break;
      case 2:
        make_turn(record, programmer, random);
        break;
      case 3:
        programmer.left();
        break;
      case 4:
        if (random.one_in(64)) {
          programmer.clear();
        }
        break;
      default:
        spm::echo(programmer);
        programmer.prepare();
        break;
    }
    record.add(programmer.room());
    record.add(programmer.has_work());
  }

  spm::Programmer fresh;
  record.known(fresh.put('A'), 1);
  record.known(fresh.put(static_cast<char>(0x80)), 0);
  fresh.prepare();
  Turn turn;
  turn.open();
  fresh.add_to(turn, true);
  turn.close();
  record.known(turn.bytes().size(), 4);
  record.known(turn.bytes()[0], 0x03);
  record.known(turn.bytes()[1], 0xC1);
  record.known(turn.bytes()[2], 0xBB);
  record.known(fresh.room(), 127);
  fresh.left();
  record.known(fresh.room(), 128);
}

}  // namespace vectors
