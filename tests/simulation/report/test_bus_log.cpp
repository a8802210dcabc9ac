#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <vector>

#include "simulation/report/bus_log.hpp"

namespace {

using namespace simulation;
using Bytes = std::vector<std::uint8_t>;

class Bench {
 public:
  Bench() { page_.add_reader(out_, report::Palette(false), true); }

  void say(Sender sender, Time at, const Bytes& bytes) {
    for (const std::uint8_t byte : bytes) {
      log_.on_byte({at, at + 286us, sender, byte, byte, false, false});
      at += 286us;
    }
  }
  std::string text() {
    log_.finish();
    page_.finish();
    return out_.str();
  }

 private:
  std::ostringstream out_;
  report::Page page_;
  report::BusLog log_{page_};
};

const Bytes neutral{0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x0F};
const Bytes answer{0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC, 0x0F};

}  // namespace

TEST_CASE("identical cycles are folded") {
  Bench bench;
  for (int cycle = 0; cycle < 26; ++cycle) {
    bench.say(Sender::sr, cycle * 20ms, neutral);
    bench.say(Sender::spm, cycle * 20ms + 3ms, answer);
  }
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0030 s  SPM   general      fuel gauge 18, lock mode enabled, system driving, mode 0, speedo 0\n"
        "             ... 25 more cycles like this, until 0.5056 s\n");
}

TEST_CASE("a cycle without its answer is not folded among answered ones") {
  Bench bench;
  bench.say(Sender::sr, 0ms, neutral);
  bench.say(Sender::spm, 3ms, answer);
  bench.say(Sender::sr, 20ms, neutral);
  bench.say(Sender::sr, 40ms, neutral);
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0030 s  SPM   general      fuel gauge 18, lock mode enabled, system driving, mode 0, speedo 0\n"
        "   0.0200 s  SR    general      unchanged\n"
        "             ... 1 more cycle like this, until 0.0426 s\n");
}

TEST_CASE("a change is told by field, a missing TF and a wrong checksum in words") {
  Bench bench;
  bench.say(Sender::sr, 0ms, neutral);
  bench.say(Sender::sr, 20ms, {0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x8C, 0x80, 0xD4});
  bench.say(Sender::sr, 40ms, {0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x8C, 0x80, 0xD5, 0x0F});
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0200 s  SR    general      remote inhibit (no TF)\n"
        "   0.0400 s  SR    corrupt      wrong checksum: 60 C0 C0 FF C0 80 8C 80 D5\n");
}

TEST_CASE("while the same packets come and go, only what is new gets a line") {
  Bench bench;
  bench.say(Sender::sr, 0ms, neutral);
  bench.say(Sender::spm, 3ms, answer);
  bench.say(Sender::sr, 20ms, neutral);
  bench.say(Sender::spm, 23ms, {0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x81, 0xAB, 0x0F});
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0030 s  SPM   general      fuel gauge 18, lock mode enabled, system driving, mode 0, speedo 0\n"
        "   0.0230 s  SPM   general      speedo 1\n");
}

TEST_CASE("a packet without any bit says so") {
  Bench bench;
  bench.say(Sender::spm, 0ms, {0x05, 0x80, 0xFA, 0x0F});
  CHECK(bench.text() == "   0.0000 s  SPM   power-up     nothing set\n");
}

TEST_CASE("an attendant control has its own lines, and its turns are folded with the others") {
  Bench bench;
  for (int cycle = 0; cycle < 3; ++cycle) {
    bench.say(Sender::sr, cycle * 20ms, neutral);
    bench.say(Sender::spm, cycle * 20ms + 3ms, answer);
    bench.say(Sender::sacu, cycle * 20ms + 6ms, {0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4, 0x0F});
  }
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0030 s  SPM   general      fuel gauge 18, lock mode enabled, system driving, mode 0, speedo 0\n"
        "   0.0060 s  SACU  general      speed 512, direction 512, pot 255, attendant, requested mode 0\n"
        "             ... 2 more cycles like this, until 0.0483 s\n");
}

TEST_CASE("characters of the programmer are told every time, and break no fold") {
  Bench bench;
  bench.say(Sender::sr, 0ms, neutral);
  for (int cycle = 1; cycle < 4; ++cycle) {
    bench.say(Sender::sr, cycle * 20ms, {0x60, 0xC0, 0xC0, 0xFF, 0xC0, 0x80, 0x84, 0x80, 0xDC, 0x02, 0x8D, 0xF0, 0x0F});
  }
  CHECK(bench.text() ==
        "   0.0000 s  SR    general      speed 512, direction 512, pot 255, HHP may send, requested mode 0\n"
        "   0.0226 s  SR    HHP data     \"\\r\"\n"
        "   0.0426 s  SR    HHP data     \"\\r\"\n"
        "   0.0626 s  SR    HHP data     \"\\r\"\n");
}
