// The power module as a speaker: when it answers, and what (sections 2, 3 and 5 of the document).
#include "spm/spm.hpp"

#include <catch2/catch.hpp>

#include "tests/support/bench.hpp"

namespace {

using namespace support;
using spm::Phase;

// ---- power-up

TEST_CASE("after reset the module is silent, whatever it hears, until a valid SR power-up packet",
          "[SB-3.1][SB-1.1][H-30]") {
  Bench bench;
  bench.cycle(wire::at_rest, 10);
  bench.cycle(wire::forward_fast, 10);
  bench.cycle(wire::unknown_type);
  bench.cycle(Bytes{});
  bench.cycle(corrupted(wire::sr_power_up));
  bench.cycle({0x44, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0x83});  // sound, but too short (SB-5.3)
  bench.hear({0x00, 0x01, 0x03, 0x00});                     // the wake edge as real chairs hear it
  bench.run_ms(100);
  CHECK(bench.turns().empty());
  CHECK(bench.is_still());
  CHECK(bench.is_braked());
  CHECK(bench.spm().phase() == Phase::silent);
  CHECK(bench.spm().inhibits().has(spm::Inhibit::no_general_yet));
}

TEST_CASE("each valid SR power-up packet is answered with an SPM power-up packet and TF", "[SB-3.2][SB-05.1][SB-2.6]") {
  Bench bench;
  for (int i = 0; i < 5; ++i) {
    bench.cycle(wire::sr_power_up);
    REQUIRE(bench.turns().size() == static_cast<std::size_t>(i + 1));
    CHECK(bench.last_turn() == Bytes{0x05, 0x80, 0xFA, 0x0F});
  }
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("old and short power-up packets are answered as well", "[SB-3.2][SB-04.1][SB-5.2]") {
  for (const Bytes& packet : {Bytes{0x74, 0x82, 0x85, 0x82, 0x80, 0x88, 0xCD, 0xA0, 0x80, 0x8D},
                              Bytes{0x74, 0x81, 0x8D, 0x83, 0x80, 0x9A, 0xDF, 0xA7, 0x80, 0xDA},
                              Bytes{0x54, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA9}}) {
    Bench bench;
    bench.cycle(packet);
    REQUIRE(bench.turns().size() == 1);
    CHECK(bench.last_turn() == Bytes{0x05, 0x80, 0xFA, 0x0F});
  }
}

TEST_CASE("the remote's identity is that of its last power-up packet", "[SB-04.1]") {
  Bench bench;
  bench.cycle(wire::sr_power_up);
  CHECK(bench.spm().remote().serial == 4810);
  bench.cycle({0x74, 0x81, 0x8D, 0x83, 0x80, 0x9A, 0xDF, 0xA7, 0x80, 0xDA});
  CHECK(bench.spm().remote().serial == 3423);
}

TEST_CASE("the first valid general ends the power-up phase and is itself answered with a general", "[SB-3.3][SB-2.7]") {
  Bench bench = Bench::greeted();
  CHECK(bench.spm().phase() == Phase::greeting);
  bench.cycle(wire::at_rest);
  REQUIRE(bench.turns().size() == 2);
  CHECK(bench.last_turn()[0] == 0x61);
  CHECK(bench.spm().phase() == Phase::running);
  CHECK_FALSE(bench.spm().inhibits().has(spm::Inhibit::no_general_yet));
}

TEST_CASE("the first general ever says: inhibited, neutral awaited, lock mode enabled, gauge 0", "[SB-01.1][SB-01.8]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::at_rest);
  // byte 1: inhibited; byte 2: lock mode enable and temporary drive modification; then the settings
  CHECK(bench.last_turn() == Bytes{0x61, 0x80, 0xC0, 0xE0, 0x80, 0x80, 0x80, 0x80, 0xFE,  //
                                   0x1A, 0xA5, 0xA7, 0x99, 0x0F});
}

TEST_CASE("a corrupt general in the power-up phase is not answered and does not end it", "[SB-3.3][SB-2.13]") {
  Bench bench = Bench::greeted();
  bench.cycle(corrupted(wire::at_rest));
  CHECK(bench.turns().size() == 1);
  CHECK(bench.spm().phase() == Phase::greeting);
}

TEST_CASE("a power-up packet from a running remote stops the chair, makes it limp and begins the phase anew",
          "[SB-3.4][H-09]") {
  Bench bench = Bench::driving();
  bench.cycle(wire::sr_power_up);
  CHECK(bench.last_turn() == Bytes{0x05, 0x80, 0xFA, 0x0F});
  CHECK(bench.is_transient());
  CHECK(bench.is_limping());
  CHECK(bench.spm().phase() == Phase::greeting);
  CHECK(bench.spm().inhibits().has(spm::Inhibit::no_general_yet));
  CHECK(bench.has_event(spm::EventCode::remote_restarted));
  bench.run_ms(1500);
  CHECK(bench.is_still());
  bench.run_ms(250);
  CHECK(bench.is_braked());

  bench.cycle(wire::forward_fast, 100);  // the stick still held
  CHECK(bench.last_turn()[0] == 0x61);
  CHECK(bench.is_still());
  CHECK_FALSE(bench.is_transient());
  CHECK(bench.is_limping());
  CHECK(bench.system_state() == 9);
}

// ---- when to answer

TEST_CASE("a general is answered right after TF, once", "[SB-2.7][SB-2.12]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.hear(wire::at_rest + wire::tf);
  const Microseconds tf_end = bench.now();
  bench.run_ms(60);
  REQUIRE(bench.turns().size() == before + 1);
  CHECK(bench.turns().back().start - tf_end <= 100);
}

TEST_CASE("other packets of the turn may follow the general and do not delay the answer", "[SB-2.7][SB-5.1]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.cycle(wire::at_rest + packet_of(2, 8, 0xC1) + wire::unknown_type + packet_of(6, 1));
  CHECK(bench.turns().size() == before + 1);
  CHECK(bench.last_turn()[0] == 0x61);
}

TEST_CASE("a turn without TF is answered 3.0 to 3.5 ms after its last byte", "[SB-2.12]") {
  for (Microseconds phase = 0; phase < 500; phase += 23) {
    Bench bench = Bench::ready();
    bench.run_us(phase);
    const std::size_t before = bench.turns().size();
    bench.hear(wire::at_rest);
    const Microseconds last = bench.now();
    bench.run_ms(10);
    CAPTURE(phase);
    REQUIRE(bench.turns().size() == before + 1);
    CHECK(bench.turns().back().start - last >= 3000);
    CHECK(bench.turns().back().start - last <= 3500);
  }
}

TEST_CASE("an unfinished packet after the general does not cost the answer", "[SB-2.12][SB-2.13]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.hear(wire::at_rest + Bytes{0x02});
  bench.run_ms(15);
  CHECK(bench.turns().size() == before + 1);
}

TEST_CASE("a turn with a valid general and another packet corrupt is answered", "[SB-2.13]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.cycle(corrupted(wire::unknown_type) + wire::at_rest);
  bench.cycle(wire::at_rest + corrupted(wire::unknown_type));
  CHECK(bench.turns().size() == before + 2);
}

TEST_CASE("a turn without a valid general is not answered", "[SB-2.13][SB-2.9][H-05][H-30]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.cycle(corrupted(wire::at_rest));
  bench.cycle(wire::at_rest);
  bench.cycle(Bytes{});
  bench.cycle(wire::unknown_type);
  bench.cycle({0x40, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0xBF});  // too short a general
  CHECK(bench.turns().size() == before + 1);
}

TEST_CASE("a SACU's turn is not answered", "[SB-2.8]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.hear(wire::at_rest + wire::tf);
  bench.run_ms(5);
  bench.hear(Bytes{0x58, 0xC0, 0xC0, 0xFF, 0xC0, 0x84, 0x80, 0xE4} + wire::tf);
  bench.run_ms(10);
  CHECK(bench.turns().size() == before + 1);
}

TEST_CASE("nobody is talked over: a turn that goes on after 3 ms keeps the line", "[SB-2.12][H-30]") {
  for (Microseconds gap = 2900; gap < 3480; gap += 23) {
    Bench bench = Bench::ready();
    bench.run_us(472);  // the last byte comes 10 us after a step: the first one to notice the silence is 3490 us later
    const std::size_t before = bench.turns().size();
    bench.hear(wire::at_rest);
    bench.run_us(gap - Bench::character);
    CAPTURE(gap);
    bench.hear(wire::unknown_type);  // the bench fails if the module speaks meanwhile
    CHECK(bench.turns().size() == before);
  }
}

TEST_CASE("an old remote's general of 6 data bytes is answered in drive mode", "[SB-00.3][SB-5.3][H-32]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.cycle({0x50, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0xAF}, 3);
  CHECK(bench.turns().size() == before + 3);
  CHECK(bench.general_byte(5) == 0);
  CHECK_FALSE(bench.is_inhibit_shown());
}

TEST_CASE("a general longer than expected is taken, its rest ignored", "[SB-5.2]") {
  Bench bench = Bench::ready();
  const std::size_t before = bench.turns().size();
  bench.cycle({0x70, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x8F}, 3);
  CHECK(bench.turns().size() == before + 3);
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("a factory test packet is logged, not answered, and changes nothing", "[SB-07.1][H-28]") {
  Bench bench = Bench::driving();
  const std::size_t before = bench.turns().size();
  const int left = bench.left();
  for (const Bytes& command : {Bytes{0x27, 0x81, 0x80, 0x80, 0xD7}, Bytes{0x27, 0x86, 0xFF, 0xFF, 0xD4}}) {
    bench.hear(command + wire::tf);
    bench.run_ms(5);
  }
  CHECK(bench.turns().size() == before);
  bench.cycle(wire::forward_fast);
  CHECK(bench.left() == left);
  CHECK(bench.has_event(spm::EventCode::factory_test_heard));
  CHECK(bench.spm().events().newest(0).argument == 6);
}

TEST_CASE("an echo that differed is logged", "[SB-1.4]") {
  Bench bench = Bench::ready();
  CHECK_FALSE(bench.has_event(spm::EventCode::echo_differed));
  bench.clash();
  CHECK(bench.has_event(spm::EventCode::echo_differed));
  CHECK_FALSE(bench.is_limping());
}

TEST_CASE("an answer that would come too late is not given, and that is logged", "[SB-2.8][H-30]") {
  // The whole turn waited in the receiver while the loop stood still.
  spm::Spm module;
  spm::Inputs in;
  const auto step_with = [&](const Bytes& bytes, std::uint16_t heard_at, std::uint16_t now) {
    in.heard_count = static_cast<std::uint8_t>(bytes.size());
    for (std::uint8_t i = 0; i < bytes.size(); ++i) {
      in.heard[i] = base::HeardByte{bytes[i], false, base::Stamp(heard_at)};
    }
    in.stamp = base::Stamp(now);
    return module.step(in, base::Instant(now / 1000U));
  };
  const auto feed = [&](std::uint16_t heard_at, std::uint16_t now) {
    step_with({0x74, 0x82, 0x86, 0x8B}, heard_at, now);
    step_with({0x80, 0xA5, 0xCA, 0xA5}, heard_at, now);
    step_with({0x83, 0xE1}, heard_at, now);
    return step_with({0x0F}, heard_at, now);
  };
  CHECK(feed(1000, 2500).speech == spm::Speech::speak);
  CHECK(feed(11000, 12501).speech == spm::Speech::hush);
  CHECK(module.events().newest(0).code == static_cast<std::uint8_t>(spm::EventCode::answer_too_late));
}

TEST_CASE("a turn that was begun and given up is not begun again", "[SB-1.4][SB-2.18][H-30]") {
  // The transmitter answered by itself and gave way before the loop came to see the TF.
  spm::Spm module;
  spm::Inputs in;
  const auto step_with = [&](const Bytes& bytes, std::uint16_t heard_at, std::uint16_t now) {
    in.heard_count = static_cast<std::uint8_t>(bytes.size());
    for (std::uint8_t i = 0; i < bytes.size(); ++i) {
      in.heard[i] = base::HeardByte{bytes[i], false, base::Stamp(heard_at)};
    }
    in.stamp = base::Stamp(now);
    return module.step(in, base::Instant(now / 1000U));
  };
  const Bytes power_up{0x74, 0x82, 0x86, 0x8B, 0x80, 0xA5, 0xCA, 0xA5, 0x83, 0xE1};
  CHECK(step_with(power_up, 1000, 1300).speech == spm::Speech::arm);
  in.echo_differed = true;
  CHECK(step_with({0x0F}, 1300, 2100).speech == spm::Speech::as_it_is);
  in.echo_differed = false;
  CHECK(step_with(power_up, 21000, 21300).speech == spm::Speech::arm);
  CHECK(step_with({0x0F}, 21300, 22100).speech == spm::Speech::speak);
}

// ---- what to say

TEST_CASE("settings come in the first answer and in every 49th after it", "[SB-0A.1][SB-0A.2]") {
  Bench bench = Bench::greeted();
  std::vector<std::size_t> with_settings;
  for (std::size_t i = 1; i <= 150; ++i) {
    bench.cycle(wire::at_rest);
    const Bytes& turn = bench.last_turn();
    if (turn.size() > 10) {
      with_settings.push_back(i);
      CHECK(Bytes(turn.begin() + 9, turn.end()) == Bytes{0x1A, 0xA5, 0xA7, 0x99, 0x0F});
    }
  }
  CHECK(with_settings == std::vector<std::size_t>{1, 50, 99, 148});  // every 980 ms
}

TEST_CASE("settings come at least once a second, however slowly the remote sends", "[SB-0A.1]") {
  for (const Microseconds period : {19970, 20340, 25000, 37000, 50000, 60000}) {
    Bench bench = Bench::greeted();
    bench.cycle(wire::at_rest, 300, period);
    Microseconds last = 0;
    std::size_t seen = 0;
    for (const Spoken& turn : bench.turns()) {
      if (turn.bytes.size() == 14) {
        CAPTURE(period);
        REQUIRE((seen == 0 || turn.start - last <= 1000000));
        last = turn.start;
        ++seen;
      }
    }
    CHECK(seen >= 300 * static_cast<std::size_t>(period) / 1000000);
  }
}

TEST_CASE("settings come again with the first answer after each power-up phase", "[SB-0A.1]") {
  Bench bench = Bench::ready();
  bench.cycle(wire::at_rest, 3);
  CHECK(bench.last_turn().size() == 10);
  bench.cycle(wire::sr_power_up);
  bench.cycle(wire::at_rest);
  CHECK(bench.last_turn().size() == 14);
}

TEST_CASE("the settings packet says what is set", "[SB-0A.2][0A.0.5][0A.0.4][0A.0.3-0][0A.1.6-0]") {
  spm::Settings settings;
  settings.set(spm::Setting::speedo_option, 0);
  settings.set(spm::Setting::click_on_keypress, 1);
  settings.set(spm::Setting::speed_button_sensitivity, 10);
  settings.set(spm::Setting::joystick_switch_threshold, 100);
  Bench bench = Bench::greeted(Bench(1000, settings));
  bench.cycle(wire::at_rest);
  const Bytes& turn = bench.last_turn();
  CHECK(Bytes(turn.begin() + 9, turn.end()) == sealed({0x1A, 0x9A, 0xE4}) + wire::tf);
}

TEST_CASE("our longest turn is over 8.5 ms after it began", "[SB-2.2][H-30]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::at_rest, 200);
  for (const Spoken& turn : bench.turns()) {
    REQUIRE(turn.end - turn.start <= 8500);
  }
}

TEST_CASE("captured from a real chair: inhibited by the remote, at rest, battery empty", "[SB-01.2][SB-00.4]") {
  Bench bench = Bench::ready();
  bench.in.battery = base::Millivolts(22000);  // empty, and not yet low (H-26)
  bench.cycle(wire::at_rest, 1500);
  bench.cycle({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8}, 3);
  CHECK(bench.last_turn() == Bytes{0x61, 0x80, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x0F});
}

TEST_CASE("captured from a real chair: driving, standing still, battery full", "[SB-01.4][SB-01.7]") {
  Bench bench = Bench::ready();
  bench.in.battery = base::Millivolts(25400);
  bench.cycle(wire::at_rest, 600);
  bench.cycle(wire::forward_slow, 20);
  bench.cycle(wire::at_rest, 40);  // half a second of braking, then the brakes' 0.8 s
  CHECK(bench.is_still());
  CHECK(bench.last_turn() == Bytes{0x61, 0x92, 0x80, 0xC0, 0xA0, 0x80, 0x80, 0x80, 0xAC, 0x0F});
}

TEST_CASE("captured from a real chair: full stick at pot 0 while limping after a lost link",
          "[SB-2.16][SB-01.1][SB-01.7][SB-01.9]") {
  Bench bench = Bench::ready();
  bench.in.battery = base::Millivolts(25100);  // up from 24 V: the gauge has not yet come to its last step
  bench.run_ms(100);
  bench.cycle(wire::at_rest, 600);
  bench.cycle(wire::forward_slow, 120);
  CHECK(bench.last_turn() == Bytes{0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87, 0xFE, 0x0F});
}

TEST_CASE("the gauge reads 0 for half a second, then the battery", "[SB-01.1]") {
  Bench bench;
  bench.in.battery = base::Millivolts(25400);
  bench.cycle(wire::sr_power_up);
  while (bench.now() < 1480000) {
    bench.cycle(wire::at_rest);
    REQUIRE((bench.general_byte(0) & 0x1F) == 0);
  }
  bench.cycle(wire::at_rest, 10);
  CHECK(bench.general_byte(0) == 18);
}

TEST_CASE("the horn button is passed back as the sound of the horn", "[SB-01.3][SB-00.2]") {
  Bench bench = Bench::ready();
  bench.cycle(sr_general({.byte4 = 0x02}));
  CHECK(bench.general_bit(2, 0));
  bench.cycle(wire::at_rest);
  CHECK_FALSE(bench.general_bit(2, 0));
}

TEST_CASE("without lighting or actuators all their bits stay 0, whatever the remote can and asks",
          "[SB-3.6][SB-3.7][SB-01.4][SB-01.5][SB-01.6]") {
  Bench bench = Bench::ready();
  for (int i = 0; i < 100; ++i) {
    bench.cycle({0x60, 0xC1, 0xBF, 0xFF, 0xC8, 0x80, 0xC4, 0x90, 0x84});  // hazard and headlight
    REQUIRE((bench.general_byte(3) & 0x1F) == 0);
    REQUIRE(bench.general_byte(4) == 0);
    REQUIRE((bench.general_byte(5) & 0x60) == 0);
    REQUIRE_FALSE(bench.outputs().left_indicator);
    REQUIRE_FALSE(bench.outputs().right_indicator);
    REQUIRE_FALSE(bench.outputs().headlight);
  }
}

TEST_CASE("lock mode is offered as its setting says", "[SB-01.3]") {
  spm::Settings settings;
  settings.set(spm::Setting::lock_mode_enable, 0);
  Bench bench = Bench::ready(Bench(1000, settings));
  CHECK_FALSE(bench.general_bit(2, 6));
  CHECK(Bench::ready().general_bit(2, 6));
}

}  // namespace
