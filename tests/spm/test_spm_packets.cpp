// What the module makes of packets other than the remote's generals and power-ups: all types and lengths, and those it
// only keeps for now.
#include <catch2/catch.hpp>

#include "spm/spm.hpp"
#include "tests/support/bench.hpp"

namespace {

using namespace support;
using spm::EventCode;

// SB-5.3 by type, 9 = no length is enough: not for us or reserved, and then never too short either.
const unsigned least[16] = {6, 9, 1, 9, 6, 9, 1, 3, 6, 7, 9, 9, 9, 9, 9, 9};

// As a start byte, type F with one data byte is TF; what follows it is then a run of stray bytes (SB-2.6).
bool is_tf(unsigned type, unsigned length) {
  return type == 15 && length == 1;
}
bool is_too_short(unsigned type, unsigned length) {
  return least[type] != 9 && length < least[type];
}

TEST_CASE("each type in each length with a right checksum is corrupt if too short, and sound otherwise",
          "[SB-5.1][SB-5.2][SB-5.3][SB-2.10][SB-2.14]") {
  for (unsigned type = 0; type < 16; ++type) {
    for (unsigned length = 1; length <= 8; ++length) {
      Bench bench = Bench::greeted();
      const Bytes packet = packet_of(type, length);
      const Bytes corrupt = corrupted(wire::unknown_type);
      bench.hear(corrupt, 2);
      bench.hear(packet);
      CAPTURE(type, length);
      const bool is_corrupt = is_too_short(type, length) || is_tf(type, length);
      CHECK(bench.spm().active_faults().has(spm::Fault::corrupt_packets) == is_corrupt);
      bench.hear(corrupt, 2);
      CHECK(bench.is_transient() == is_corrupt);
      bench.hear(corrupt);
      CHECK(bench.is_transient());
    }
  }
}

TEST_CASE("each type in each length with a wrong checksum is corrupt, and nothing comes of it",
          "[SB-2.5][SB-2.9][SB-2.10][SB-2.13][SB-2.14]") {
  for (unsigned type = 0; type < 16; ++type) {
    for (unsigned length = 1; length <= 8; ++length) {
      Bench bench = Bench::ready();
      const std::size_t before = bench.turns().size();
      const std::uint16_t events = bench.spm().events().total();
      const Bytes packet = corrupted(packet_of(type, length, 0xAA));
      CAPTURE(type, length);
      bench.hear(packet, 2);
      CHECK_FALSE(bench.is_transient());
      CHECK(bench.spm().events().total() == events);
      bench.hear(packet + wire::tf);
      CHECK(bench.is_transient());
      bench.run_ms(10);
      CHECK(bench.turns().size() == before);
      CHECK(bench.spm().phase() == spm::Phase::running);
      CHECK_FALSE(bench.spm().attendant().has_value());
      CHECK_FALSE(bench.spm().attendant_general().has_value());
      CHECK_FALSE(bench.spm().programmer().has_work());
      CHECK_FALSE(bench.has_event(EventCode::factory_test_heard));
    }
  }
}

TEST_CASE("packets that only a power module says are nothing to us", "[SB-5.1]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  for (int i = 0; i < 10; ++i) {
    bench.hear({0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC});
    bench.hear({0x05, 0x87, 0xF3});
    bench.hear({0x1A, 0xA5, 0xA7, 0x99});
    bench.hear({0x03, 0xC1, 0xBB});
    bench.hear(wire::tf);
    bench.run_ms(1);
    bench.cycle(wire::at_rest);
  }
  CHECK(bench.turns().size() == before + 10);
  CHECK_FALSE(bench.is_transient());
  CHECK_FALSE(bench.spm().programmer().has_work());
}

// ---- the attendant control

const Bytes sacu_power_up{0x69, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0x8C};
const Bytes sacu_general{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4};

// The remote's turn, ours, and the attendant control's.
void cycle(Bench& bench, const Bytes& remote, const Bytes& attendant) {
  const Microseconds end = bench.now() + 20000;
  bench.hear(remote + wire::tf);
  bench.run_ms(8);
  bench.hear(attendant + wire::tf);
  bench.run_until(end);
}

TEST_CASE("an attendant control's turn is understood, kept, and not answered", "[SB-2.8][SB-08.1][SB-09.1]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  CHECK_FALSE(bench.spm().attendant().has_value());
  cycle(bench, wire::at_rest, sacu_power_up);
  REQUIRE(bench.spm().attendant().has_value());
  CHECK(bench.spm().attendant()->serial == 1545925);
  CHECK(bench.spm().attendant()->supports_actuator1);
  CHECK_FALSE(bench.spm().attendant_general().has_value());
  cycle(bench, wire::at_rest, sacu_general);
  REQUIRE(bench.spm().attendant_general().has_value());
  CHECK(bench.spm().attendant_general()->attendant);
  CHECK(bench.spm().attendant_general()->pot.count() == 255);
  CHECK(bench.turns().size() == before + 2);
  CHECK_FALSE(bench.is_transient());
}

TEST_CASE("an attendant control's stick moves nothing yet", "[SB-08.1]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 50; ++i) {
    cycle(bench, wire::at_rest, {0x58, 0xFF, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xA5});
  }
  CHECK(bench.spm().attendant_general()->speed.count() == 1016);
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
}

TEST_CASE("longer packets of an attendant control are taken for what we know of them", "[SB-5.2][SB-08.1][SB-09.1]") {
  Bench bench = Bench::ready();
  cycle(bench, wire::at_rest, {0x79, 0x8A, 0x89, 0xDE, 0xAD, 0xC5, 0xA5, 0x82, 0xFF, 0xFD});
  cycle(bench, wire::at_rest, {0x78, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xFF, 0xFF, 0xC6});
  REQUIRE(bench.spm().attendant().has_value());
  CHECK(bench.spm().attendant()->version == 0x25);
  REQUIRE(bench.spm().attendant_general().has_value());
  CHECK(bench.spm().attendant_general()->requested_mode == 0);
}

// ---- joystick calibration

const Bytes forward_seen{0x06, 0x88, 0xF1};
const Bytes all_seen{0x06, 0xBF, 0xBA};

TEST_CASE("calibration progress belongs to whoever's turn it is", "[SB-06.1]") {
  Bench bench = Bench::ready();
  cycle(bench, wire::calibrating + forward_seen, sacu_general);
  CHECK(bench.spm().remote_calibration().forward_seen);
  CHECK_FALSE(bench.spm().remote_calibration().reverse_seen);
  CHECK_FALSE(bench.spm().attendant_calibration().forward_seen);
  cycle(bench, wire::at_rest, sacu_general + all_seen);
  CHECK(bench.spm().attendant_calibration().second_pass);
  CHECK(bench.spm().attendant_calibration().neutral_seen);
  CHECK(bench.spm().attendant_calibration().right_seen);
  CHECK(bench.spm().remote_calibration().forward_seen);
  CHECK_FALSE(bench.spm().remote_calibration().second_pass);
}

TEST_CASE("the latest calibration progress counts", "[SB-06.1]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::calibrating + forward_seen);
  bench.cycle(wire::calibrating + Bytes{0x06, 0x84, 0xF5});
  CHECK_FALSE(bench.spm().remote_calibration().forward_seen);
  CHECK(bench.spm().remote_calibration().reverse_seen);
}

TEST_CASE("calibration progress in a turn that began with nobody's general is nobody's", "[SB-06.1]") {
  Bench bench = Bench::ready();
  bench.cycle(corrupted(wire::calibrating) + all_seen);
  bench.hear(wire::calibrating);  // no TF: after 3 ms that turn is over
  bench.run_ms(17);
  bench.cycle(all_seen);
  bench.hear(wire::calibrating);
  bench.in.wake = true;  // what was heard before it is over as well
  bench.run_ms(1);
  bench.in.wake = false;
  bench.cycle(all_seen);
  CHECK_FALSE(bench.spm().remote_calibration().second_pass);
  CHECK_FALSE(bench.spm().attendant_calibration().second_pass);
}

TEST_CASE("a remote that powers up again makes us forget everybody else", "[SB-3.4]") {
  Bench bench = Bench::ready();
  cycle(bench, wire::calibrating + all_seen, sacu_power_up);
  cycle(bench, wire::at_rest, sacu_general + all_seen);
  bench.cycle(wire::sr_power_up);
  CHECK_FALSE(bench.spm().attendant().has_value());
  CHECK_FALSE(bench.spm().attendant_general().has_value());
  CHECK_FALSE(bench.spm().attendant_calibration().second_pass);
  CHECK_FALSE(bench.spm().remote_calibration().second_pass);
}

// ---- factory test

TEST_CASE("a factory test is logged with its command and never answered", "[SB-07.1][07.0.3-0]") {
  for (unsigned command = 0; command < 16; ++command) {
    for (const unsigned length : {3U, 8U}) {
      Bench bench = Bench::ready();
      const std::size_t before = bench.turns().size();
      Bytes packet = packet_of(7, length);
      packet.pop_back();
      packet[1] = static_cast<std::uint8_t>(0x80 + 0x70 + command);
      bench.cycle(sealed(packet));
      CHECK(bench.turns().size() == before);
      CHECK(bench.spm().events().newest(0).code == 3);
      CHECK(bench.spm().events().newest(0).argument == command);
      CHECK_FALSE(bench.is_transient());
    }
  }
}

}  // namespace
