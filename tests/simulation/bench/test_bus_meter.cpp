#include <catch2/catch.hpp>

#include "simulation/bench/bus_meter.hpp"

namespace {

using namespace simulation;
using namespace simulation::bench;

constexpr Time character = 286us;

// Cycles of a remote, a power module and an attendant control, as the wire would report them.
struct Line {
  BusMeter meter;

  Time say(Sender sender, Time at, int bytes, Time pause = {}) {
    for (int i = 0; i < bytes; ++i) {
      BusByte byte;
      byte.start = at;
      byte.end = at + character;
      byte.sender = sender;
      byte.sent = byte.heard = i == bytes - 1 ? 0x0F : 0x80;
      meter.on_byte(byte);
      at = byte.end + (i == bytes - 1 ? Time{} : pause);
    }
    return at;
  }
  RunFigures figures(bool has_sacu = true) {
    RunFigures figures;
    figures.has_sacu = has_sacu;
    meter.tell(figures);
    return figures;
  }
};

TEST_CASE("the bench reads answers, pauses, turns and utilisation off the bus") {
  Line line;
  for (int i = 0; i < 4; ++i) {
    const Time from = i * 20ms;
    const Time answer = line.say(Sender::sr, from, 10) + 8us + i * 1us;
    const Time sacu = line.say(Sender::spm, answer, 20, i == 1 ? 2us : 0us) + 100us;
    line.say(Sender::sacu, sacu, 9);
  }
  const RunFigures figures = line.figures();  // of three cycles: the fourth has not ended
  CHECK(figures.cycles == 3);
  CHECK(figures.broken_cycles == 0);
  CHECK(figures.answer.count == 4);
  CHECK(figures.answer.least == Approx(8));
  CHECK(figures.answer.most == Approx(11));
  CHECK(figures.pause.count == 4 * 19);
  CHECK(figures.pause.median == Approx(0).margin(0.001));
  CHECK(figures.pause.most == Approx(2));
  CHECK(figures.sr.length.median == Approx(2860));
  CHECK(figures.spm.length.least == Approx(5720));
  CHECK(figures.spm.length.most == Approx(5720 + 19 * 2));
  CHECK(figures.spm.bytes.median == Approx(20));
  CHECK(figures.sacu.bytes.median == Approx(9));
  CHECK(figures.end_of_talk.least == Approx(2860 + 8 + 5720 + 100 + 2574));
  CHECK(figures.utilisation.least == Approx((2860 + 5720 + 2574) / 20000.0));
  CHECK(line.meter.busy_us(10, 20, 9) == Approx(2860 + 5720 + 2574));
  CHECK_FALSE(line.meter.busy_us(10, 10, 9).has_value());
}

TEST_CASE("the bench finds a cycle in which something is missing or in the way") {
  Line line;
  const auto rest = [&line](Time from) {
    line.say(Sender::sacu, line.say(Sender::spm, line.say(Sender::sr, from, 10) + 8us, 10) + 100us, 9);
  };
  rest(0ms);
  SECTION("nothing") {
    rest(20ms);
    rest(40ms);
    CHECK(line.figures().broken_cycles == 0);
  }
  SECTION("no answer") {
    line.say(Sender::sr, 20ms, 10);
    rest(40ms);
    CHECK(line.figures(false).broken_cycles == 1);
  }
  SECTION("no attendant control, where there is one") {
    line.say(Sender::spm, line.say(Sender::sr, 20ms, 10) + 8us, 10);
    rest(40ms);
    CHECK(line.figures(false).broken_cycles == 0);
    CHECK(line.figures(true).broken_cycles == 1);
  }
  SECTION("an answer into the remote's turn") {
    line.say(Sender::spm, line.say(Sender::sr, 20ms, 10) - 10us, 10);
    line.say(Sender::sacu, 30ms, 9);
    rest(40ms);
    CHECK(line.figures().broken_cycles == 1);
  }
  SECTION("an attendant control that is not done when the next cycle begins") {
    line.say(Sender::spm, line.say(Sender::sr, 20ms, 10) + 8us, 10);
    line.say(Sender::sacu, 38ms, 9);
    rest(40ms);
    CHECK(line.figures().broken_cycles >= 1);
  }
}

TEST_CASE("the bench counts bytes that were spoiled, changed or lost, from where it begins to measure") {
  Line line;
  BusByte byte;
  byte.spoiled = true;
  line.meter.on_byte(byte);
  line.meter.begin();
  CHECK(line.figures().losses.spoiled == 0);
  line.meter.on_byte(byte);
  byte.spoiled = false;
  byte.lost = true;
  line.meter.on_byte(byte);
  byte.lost = false;
  byte.sent = 0x81;
  byte.heard = 0x80;
  line.meter.on_byte(byte);
  byte.heard = 0x81;
  line.meter.on_byte(byte);
  CHECK(line.figures().losses.spoiled == 3);
}

}  // namespace
