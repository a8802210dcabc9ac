// A power module on a bench: its bus, its clock and a watch over what it must never do.
//
//   auto bench = Bench::driving();
//   bench.cycle(corrupted(wire::forward_fast), 3);
//   CHECK(bench.spm().faults().is_transient);
//
// Time is counted in microseconds and moved by the test alone. The module is stepped as the board steps it: at every
// heard byte, every 500 us and so every millisecond. Characters last 286 us. The transmitter is a second telling of
// what drivers/serial.hpp promises: an armed turn begins right after TF, and nothing of our own comes back as heard.
//
// After every step the bench holds the outputs against rules no test may break (H-01, H-12 to H-14, H-33), and every
// turn against the wire's own (SB-2.4, SB-2.5, SB-5.4); a breach fails the test wherever it stands.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <string>
#include <vector>

#include "spm/spm.hpp"
#include "tests/support/wire_words.hpp"

namespace support {

using Microseconds = std::int64_t;

struct Spoken {
  Bytes bytes;
  Microseconds start;
  Microseconds end;
};

class Bench {
 public:
  static constexpr Microseconds character = 286;
  static constexpr Microseconds grain = 500;
  // No test lasts longer; one that does waits for something that will not come.
  static constexpr Microseconds longest_test = Microseconds{3600} * 1000000;
  // A receiver hands a character over at its first stop bit, before the second has ended.
  static constexpr Microseconds until_delivered = 250;
  // What the default ramps may change a wheel in a millisecond, rounded up: at most 480 permille a second of speed down
  // and 350 of turn up, which make an inner wheel run backwards; in a stop 800 of each down.
  static constexpr int most_rise = 14;
  static constexpr int most_fall = 27;

  explicit Bench(std::uint32_t start_ms = 1000, const spm::Settings& settings = spm::Settings())
      : now_(Microseconds{start_ms} * 1000), begin_(now_), spm_(settings) {
    in.battery = base::Millivolts(24000);
    in.analog_ready = true;
    step();
  }

  // The power-up handshake is done; no general has been heard.
  static Bench greeted(Bench bench = Bench()) {
    bench.cycle(wire::sr_power_up);
    return bench;
  }
  // Generals come, neutral has been seen, the gauge has settled; brakes engaged.
  static Bench ready(Bench bench = Bench()) {
    bench = greeted(std::move(bench));
    bench.cycle(wire::at_rest, 50);
    return bench;
  }
  // Full forward at full speed.
  static Bench driving(Bench bench = Bench()) {
    bench = ready(std::move(bench));
    bench.cycle(wire::forward_fast, 400);
    return bench;
  }

  // ---- the world

  spm::Inputs in;  // what stays as it is from step to step: battery, wake, start cause

  std::int32_t left_coil = 650;  // mA, while it is switched on
  std::int32_t right_coil = 650;
  std::int32_t stray_coil = 0;  // and always

  void run_until(Microseconds limit) {
    for (Microseconds next = (now_ / grain + 1) * grain; next <= limit; next += grain) {
      now_ = next;
      step();
    }
    now_ = std::max(now_, limit);
    if (now_ - begin_ > longest_test) {
      FAIL("an hour has passed");
    }
  }
  void run_us(Microseconds span) { run_until(now_ + span); }
  void run_ms(Microseconds span) { run_until(now_ + span * 1000); }

  void hear_byte(std::uint8_t value, bool is_spoiled = false) {
    run_until(now_ + until_delivered);
    INFO("the test talks over the power module");
    REQUIRE(now_ >= speaking_until_);
    if (is_armed_ && value == 0x0F && !is_spoiled) {  // the driver starts before the loop has seen TF
      begin_to_speak(now_ + character - until_delivered);
    }
    in.heard[0] = base::HeardByte{value, is_spoiled, base::Stamp(static_cast<std::uint16_t>(now_))};
    in.heard_count = 1;
    step();
    run_until(now_ + character - until_delivered);
  }
  void hear(const Bytes& bytes, int times = 1) {
    for (int i = 0; i < times; ++i) {
      for (const std::uint8_t byte : bytes) {
        hear_byte(byte);
      }
    }
  }

  // A remote's turn, closed by TF, and the rest of its 20 ms.
  void cycle(const Bytes& packets, int times = 1, Microseconds period = 20000) {
    for (int i = 0; i < times; ++i) {
      const Microseconds end = now_ + period;
      hear(packets + wire::tf);
      run_until(end);
    }
  }

  // One step that was told the echo of our own turn differed from what was sent (SB-1.4).
  void clash() {
    in.echo_differed = true;
    step();
  }

  // ---- what came of it

  Microseconds now() const { return now_; }
  const spm::Spm& spm() const { return spm_; }
  const spm::Outputs& outputs() const { return outputs_; }
  int left() const { return outputs_.left.count(); }
  int right() const { return outputs_.right.count(); }
  bool is_still() const { return left() == 0 && right() == 0; }
  bool is_braked() const {
    return outputs_.left_brake == spm::Brake::engaged && outputs_.right_brake == spm::Brake::engaged;
  }
  bool is_transient() const { return spm_.faults().is_transient; }
  bool is_limping() const { return spm_.faults().is_limping; }
  bool is_off() const { return outputs_.latch == spm::Latch::release; }
  // How many of the newest 16 events have this code; and the argument of the newest one, -1 if there is none.
  int count_of(int code) const {
    int count = 0;
    for (std::uint8_t back = 0; back < 16; ++back) {
      count += spm_.events().newest(back).code == code ? 1 : 0;
    }
    return count;
  }
  int argument_of(int code) const {
    for (std::uint8_t back = 0; back < 16; ++back) {
      if (spm_.events().newest(back).code == code) {
        return spm_.events().newest(back).argument;
      }
    }
    return -1;
  }
  bool has_event(spm::EventCode code) const {
    for (std::uint8_t back = 0; back < faults::EventRing::capacity; ++back) {
      if (spm_.events().newest(back).code == static_cast<std::uint8_t>(code)) {
        return true;
      }
    }
    return false;
  }

  const std::vector<Spoken>& turns() const { return turns_; }
  const Bytes& last_turn() const {
    REQUIRE_FALSE(turns_.empty());
    return turns_.back().bytes;
  }
  // Data byte `index` of the newest general we spoke, without its marker.
  unsigned general_byte(std::size_t index) const {
    REQUIRE(last_turn().size() >= 9);
    REQUIRE(last_turn()[0] == 0x61);
    return last_turn()[index + 1] & 0x7FU;
  }
  bool general_bit(std::size_t index, unsigned bit) const { return (general_byte(index) >> bit & 1U) != 0; }
  bool is_inhibit_shown() const { return general_bit(1, 6); }
  bool is_power_down_asked() const { return general_bit(1, 4); }
  unsigned system_state() const { return general_byte(1) & 0x0FU; }
  bool is_neutral_demanded() const { return general_bit(2, 5); }
  bool is_driving_shown() const { return general_bit(3, 5); }
  unsigned speedo() const { return general_byte(6) & 0x1FU; }

 private:
  std::int32_t coil(spm::Brake brake, std::int32_t current) const {
    return brake == spm::Brake::released ? current : 0;
  }

  void step() {
    in.stamp = base::Stamp(static_cast<std::uint16_t>(now_));
    in.speaker = now_ < speaking_until_ ? spm::Speaker::speaking : is_armed_ ? spm::Speaker::armed : spm::Speaker::idle;
    const spm::Outputs before = outputs_;
    in.brake_coils =
        base::Milliamps(coil(outputs_.left_brake, left_coil) + coil(outputs_.right_brake, right_coil) + stray_coil);
    outputs_ = spm_.step(in, base::Instant(static_cast<std::uint32_t>(now_ / 1000)));
    in.heard_count = 0;
    in.echo_differed = false;
    obey_speech();
    watch(before);
  }

  void obey_speech() {
    switch (outputs_.speech) {
      case spm::Speech::as_it_is:
        break;
      case spm::Speech::arm:
        waiting_.assign(outputs_.turn.begin(), outputs_.turn.end());
        is_armed_ = true;
        break;
      case spm::Speech::speak:
        waiting_.assign(outputs_.turn.begin(), outputs_.turn.end());
        begin_to_speak(now_);
        break;
      case spm::Speech::hush:
      case spm::Speech::cut:
        is_armed_ = false;
        if (now_ < speaking_until_) {
          speaking_until_ = now_;
        }
        break;
    }
  }

  void begin_to_speak(Microseconds at) {
    is_armed_ = false;
    if (now_ < speaking_until_) {
      return;  // as the driver: ignored while speaking
    }
    speaking_until_ = at + static_cast<Microseconds>(waiting_.size()) * character;
    turns_.push_back(Spoken{waiting_, at, speaking_until_});
    inspect(waiting_);
    if (in.wake) {
      FAIL("it spoke while wake was asserted (SB-1.3)");
    }
  }

  // Every turn we speak: whole packets, markers, checksums, zeros where nothing is defined, TF at the end.
  static void inspect(const Bytes& turn) {
    const auto demand = [](bool is_so, const char* what) {
      if (!is_so) {
        FAIL("a spoken turn breaks the wire's rules: " << what);
      }
    };
    demand(static_cast<Microseconds>(turn.size()) * character <= 8500, "the length of a turn (SB-2.2)");
    std::size_t at = 0;
    while (at < turn.size() && turn[at] != 0x0F) {
      const std::size_t length = turn[at] / 16U + 1U;
      demand(turn[at] < 0x80, "bit 7 of a start byte (SB-2.4)");
      demand(at + length + 1 < turn.size(), "its length (SB-2.3)");
      const Bytes start_and_data(turn.begin() + static_cast<std::ptrdiff_t>(at),
                                 turn.begin() + static_cast<std::ptrdiff_t>(at + 1 + length));
      demand(std::all_of(start_and_data.begin() + 1, start_and_data.end(), [](auto byte) { return byte >= 0x80; }),
             "bit 7 of a data byte (SB-2.4)");
      demand(turn[at + 1 + length] == checksum_of(start_and_data), "a checksum (SB-2.5)");
      if (turn[at] == 0x61) {
        demand(at == 0, "the general comes first (SB-2.7)");
        demand((turn[1] & 0x1F) <= 18, "the gauge (SB-01.1)");
        demand((turn[2] & 0x0F) <= 0x0A, "the system state (SB-01.2)");
        demand((turn[3] & 0x02) == 0 && (turn[7] & 0x40) == 0, "an unused bit (SB-5.4)");
        demand((turn[6] & 0x0F) != 0 || (turn[6] & 0x10) == 0, "drive mode called invalid (SB-00.7)");
      }
      at += length + 2;
    }
    demand(at + 1 == turn.size(), "TF ends it, once (SB-2.7)");
  }

  void watch(const spm::Outputs& before) {
    const bool is_braked_somewhere = !(outputs_.left_brake == spm::Brake::released) ||  //
                                     !(outputs_.right_brake == spm::Brake::released);
    if (is_braked_somewhere && !is_still()) {
      FAIL("torque against an engaged brake (H-13)");
    }
    if (!is_still() && !(outputs_.bridge_enabled && outputs_.relay_closed)) {
      FAIL("demand without a bridge (H-01)");
    }
    if (outputs_.left_brake != outputs_.right_brake) {
      FAIL("one brake without the other (H-12)");
    }
    if (is_off() && (!is_still() || !is_braked())) {
      FAIL("the latch let go of a chair that was not at rest (H-14)");
    }
    if (outputs_.are_motors_as_before && !has_same_motors(before)) {
      FAIL("a pin of motors or brakes changed that was said to be as before");
    }
    if (outputs_.are_switches_as_before && !has_same_switches(before)) {
      FAIL("a pin changed that was said to be as before");
    }
    watch_wheel(before.left.count(), left(), left_past_, in.left_current);
    watch_wheel(before.right.count(), right(), right_past_, in.right_current);
  }

  bool has_same_motors(const spm::Outputs& before) const {
    return before.left == outputs_.left && before.right == outputs_.right &&
           before.bridge_enabled == outputs_.bridge_enabled && before.relay_closed == outputs_.relay_closed &&
           before.left_brake == outputs_.left_brake && before.right_brake == outputs_.right_brake;
  }

  bool has_same_switches(const spm::Outputs& before) const {
    return before.left_indicator == outputs_.left_indicator && before.right_indicator == outputs_.right_indicator &&
           before.headlight == outputs_.headlight && before.status_led == outputs_.status_led &&
           before.latch == outputs_.latch;
  }

  // H-33: no more than the ramps give, over one step that catches up, and over 20 ms; unless all is switched off at
  // once (H-10), or the motor has more than its peak current (H-31).
  void watch_wheel(int before, int after, std::deque<std::pair<Microseconds, int>>& past, base::Milliamps current) {
    const bool is_cut = is_braked() && !outputs_.bridge_enabled && !outputs_.relay_closed;
    if (after == before || (is_cut && after == 0)) {
      return;
    }
    const bool is_relieved = std::abs(current.count()) > 60000;
    if (is_relieved) {
      past.clear();
    }
    if (before != 0 && after != 0 && (before > 0) != (after > 0)) {
      FAIL("a wheel changed its direction without standing still");
    }
    const auto rise = [](int from, int to) { return std::abs(to) - std::abs(from); };
    if (rise(before, after) > 5 * most_rise || (rise(after, before) > 5 * most_fall && !is_relieved)) {
      FAIL("a wheel jumped from " << before << " to " << after);
    }
    while (!past.empty() && now_ - past.front().first > 20000) {
      past.pop_front();
    }
    if (!past.empty() &&
        (rise(past.front().second, after) > 25 * most_rise || rise(after, past.front().second) > 25 * most_fall)) {
      FAIL("a wheel went from " << past.front().second << " to " << after << " in 20 ms");
    }
    past.emplace_back(now_, after);
  }

  Microseconds now_;
  Microseconds begin_;
  spm::Spm spm_;
  spm::Outputs outputs_;
  bool is_armed_ = false;
  Bytes waiting_;
  Microseconds speaking_until_ = 0;
  std::vector<Spoken> turns_;
  std::deque<std::pair<Microseconds, int>> left_past_;  // when each demand of the last 20 ms began
  std::deque<std::pair<Microseconds, int>> right_past_;
};

}  // namespace support
