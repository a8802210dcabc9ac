// Each clause about the bus: a trace that breaks it, and one that nearly does.
#include <catch2/catch.hpp>

#include "tests/simulation/monitor/stage.hpp"

namespace {

using namespace stage;

bool is_caught(const std::string& breaches, const std::string& clause) {
  return breaches.find(clause) != std::string::npos;
}

// After power-up and neutral: somebody's bytes, a pause, what the power module says then, and 5 ms.
std::string breaches_of(Sender sender, const std::string& bytes, Time pause, const std::string& answer) {
  Stage stage;
  stage.wake_up();
  stage.says(sender, bytes);
  stage.run(pause);
  stage.says(Sender::spm, answer);
  stage.run(5ms);
  return stage.breaches();
}

std::string breaches_of_answer(const std::string& answer) {
  return breaches_of(Sender::sr, sr::neutral, 44us, answer);
}

const std::string general = "60 C0 C0 FF C0 80 84 80 DC ";
const std::string ready = "61 92 80 C0 80 80 80 80 CC ";

}  // namespace

TEST_CASE("H-05.2: a turn of corrupt packets is answered", "[monitor][H-05]") {
  CHECK(is_caught(breaches_of(Sender::sr, sr::corrupt, 44us, spm::ready), "H-05.2"));
  CHECK(breaches_of(Sender::sr, "02 C1 BD " + general + "0F", 44us, spm::ready) == "");
  CHECK(is_caught(breaches_of(Sender::sr, "40 C0 C0 FF C0 80 C0 0F", 44us, spm::ready), "H-05.2"));  // too short
}

TEST_CASE("H-09.2: a power-up packet is answered with a general", "[monitor][H-09]") {
  CHECK(is_caught(breaches_of(Sender::sr, sr::power_up, 44us, spm::limping_at_rest), "H-09.2"));
  CHECK(breaches_of(Sender::sr, sr::power_up, 44us, spm::power_up) == "");
}

TEST_CASE("H-28.1: a factory test is answered", "[monitor][H-28]") {
  CHECK(is_caught(breaches_of(Sender::noise, "27 80 80 80 D8 0F", 44us, spm::ready), "H-28.1"));
  CHECK(breaches_of(Sender::sr, general + "27 80 80 80 D8 0F", 44us, spm::ready) == "");
}

TEST_CASE("H-30.1: it speaks out of its slot", "[monitor][H-30]") {
  CHECK(is_caught(breaches_of(Sender::sr, sr::neutral, 1700us, spm::ready), "H-30.1"));
  CHECK(breaches_of(Sender::sr, sr::neutral, 1550us, spm::ready) == "");
  CHECK(is_caught(breaches_of(Sender::sr, general, 2900us, spm::ready), "H-30.1"));
  CHECK(breaches_of(Sender::sr, general, 3000us, spm::ready) == "");
  CHECK(breaches_of(Sender::sr, general, 4500us, spm::ready) == "");
  CHECK(is_caught(breaches_of(Sender::sr, general, 4700us, spm::ready), "H-30.1"));
}

TEST_CASE("H-30.1: it speaks a second time", "[monitor][H-30]") {
  Stage stage;
  stage.wake_up();
  stage.turn(sr::neutral, spm::ready);
  stage.run(44us);
  stage.says(Sender::spm, spm::ready);
  CHECK(stage.breaks("H-30.1"));
}

TEST_CASE("H-30.1: a second TF that the answer meets cannot have been known", "[monitor][H-30]") {
  Stage stage;
  stage.wake_up();
  stage.says(Sender::sr, sr::neutral);
  const Time end = stage.now;
  stage.says(Sender::sr, "0F");
  stage.now = end + 44us;
  stage.says(Sender::spm, "61");
  stage.run(5ms);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-30.2: a turn of the attendant control is answered", "[monitor][H-30]") {
  CHECK(is_caught(breaches_of(Sender::sacu, "58 C0 C0 FF C0 84 80 E4 0F", 44us, spm::ready), "H-30.2"));
  CHECK(is_caught(breaches_of(Sender::sacu, "69 8A 89 DE AD C5 A5 82 8C 0F", 44us, spm::ready), "H-30.2"));
  CHECK(breaches_of(Sender::sacu, "58 C0 C0 FF C0 84 80 E4 0F", 44us, spm::nothing) == "");
}

TEST_CASE("H-30.3: what it says has a flaw of form", "[monitor][H-30]") {
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80 80 CC 73 C1 C1 C1 C1 C1 C1 C1 C1 84 1A A5 A7 99 0F") == "");
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80 80 CD 0F") == "H-30.3");  // checksum
  CHECK(breaches_of_answer("61 92 00 C0 80 80 80 80 CC 0F") == "H-30.3");  // marker
  CHECK(breaches_of_answer("51 92 80 C0 80 80 80 DC 0F") == "H-30.3");     // length
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80 80 CC") == "H-30.3");     // no TF
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80") == "H-30.3");           // broken off
  CHECK(breaches_of_answer("1A A5 A7 99 0F") == "H-30.3");                 // no general
  CHECK(breaches_of_answer("1A A5 A7 99 " + ready + "0F") == "H-30.3");    // general second
  CHECK(breaches_of_answer(ready + "0B 80 F4 0F") == "H-30.3");            // not its packet
  CHECK(breaches_of_answer("0F") == "H-30.3");                             // empty
  CHECK(breaches_of_answer(ready + "8F") == "H-30.3");
  CHECK(breaches_of(Sender::sr, sr::power_up, 44us, "05 80 FA 1A A5 A7 99 0F") == "H-30.3");
}

TEST_CASE("H-30.3: a turn that meets another may break off", "[monitor][H-30]") {
  Stage stage;
  stage.wake_up();
  stage.turn(sr::neutral, "61 92 80");
  stage.now -= 100us;
  stage.says(Sender::noise, "FF");
  stage.run(5ms);
  CHECK(stage.breaches() == "");
}

TEST_CASE("H-30.4: a field it says is out of range", "[monitor][H-30]") {
  CHECK(breaches_of_answer("61 93 80 C0 80 80 80 80 CB 0F") == "H-30.4");  // gauge 19
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80 80 CC 0F") == "");        // gauge 18
  CHECK(breaches_of_answer("61 92 8B C0 80 80 80 80 C1 0F") == "H-30.4");  // state 0B
  CHECK(breaches_of_answer("61 92 8A C0 80 80 80 80 C2 0F") == "");        // state 0A
  CHECK(breaches_of_answer("61 92 80 C2 80 80 80 80 CA 0F") == "H-30.4");  // unused bits
  CHECK(breaches_of_answer("61 92 80 C0 80 80 80 C0 8C 0F") == "H-30.4");
  CHECK(breaches_of_answer(ready + "1A BA E4 C7 0F") == "");        // sensitivity 10, threshold 100
  CHECK(breaches_of_answer(ready + "1A AB A7 93 0F") == "H-30.4");  // 11
  CHECK(breaches_of_answer(ready + "1A A0 A7 9E 0F") == "H-30.4");  // 0
  CHECK(breaches_of_answer(ready + "1A A5 E5 DB 0F") == "H-30.4");  // 101
  CHECK(breaches_of_answer(ready + "1A A5 80 C0 0F") == "H-30.4");  // 0
  CHECK(breaches_of(Sender::sr, sr::power_up, 44us, "05 88 F2 0F") == "H-30.4");
}

TEST_CASE("H-30.5: it transmits for more than 10 ms of 20", "[monitor][H-30]") {
  const auto breaches = [](const std::string& second) {
    Stage stage;
    stage.wake_up();
    stage.turn(sr::neutral, "61 92 80 C0 80 80 80 80 CC 73 C1 C1 C1 C1 C1 C1 C1 C1 84 1A A5 A7 99 0F");
    stage.turn(sr::neutral, second);
    stage.run(5ms);
    return stage.breaches();
  };
  CHECK(breaches(ready + "0F") == "");                 // 34 characters
  CHECK(breaches(ready + "03 C1 BB 0F") == "H-30.5");  // 37
}

TEST_CASE("H-30.6, H-30.8: it answers before a power-up packet", "[monitor][H-30]") {
  Stage stage;
  stage.power(true);
  stage.pins.power_latch = true;
  stage.run_until(10ms);
  stage.cycle(sr::neutral, spm::inhibited);
  CHECK(stage.breaks("H-30.6"));
  Stage greeted;
  greeted.greet();
  greeted.cycle(sr::neutral, spm::inhibited);
  CHECK(greeted.breaches() == "");
}

TEST_CASE("H-30.7: it speaks under wake", "[monitor][H-30]") {
  const auto breaches = [](int characters) {
    Stage stage;
    stage.wake_up();
    stage.turn(sr::neutral, "61 92");
    stage.wake(true);
    for (int i = 0; i < characters; ++i) {
      stage.says(Sender::spm, "80");
    }
    stage.run(5ms);
    return stage.breaches();
  };
  CHECK(breaches(5) == "");  // the last begins after 1.14 ms
  CHECK(breaches(6) == "H-30.7");
}

TEST_CASE("H-30.8: TF alone, or an unknown packet, is answered", "[monitor][H-30]") {
  CHECK(is_caught(breaches_of(Sender::sr, "0F", 44us, spm::ready), "H-30.8"));
  CHECK(is_caught(breaches_of(Sender::sr, "0B 80 F4 0F", 44us, spm::ready), "H-30.8"));
  CHECK(breaches_of(Sender::sr, "0B 80 F4 " + general + "0F", 44us, spm::ready) == "");
}
