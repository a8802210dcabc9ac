// The level of the shared pair over time, as each end of the cable sees it: recessive 1 when idle, and a dominant 0
// wins, so that two who speak at once spoil each other's characters. And what a UART makes of it by its own clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/bus_event.hpp"
#include "simulation/time.hpp"

namespace simulation {

// The remote sits at one end of the cable; the power module, the attendant control and whoever else speaks at the
// other.
enum class WireEnd : std::uint8_t { remote, power_module };

// How a transmitter forms its characters: start bit, 8 data bits, stop bits.
struct CharacterFormat {
  Time bit{26'042};  // 38400 bps
  int stop_bits = 2;

  constexpr Time length() const { return (9 + stop_bits) * bit; }
};

struct Character {
  Sender sender = Sender::noise;
  std::uint8_t sent = 0;   // as the sender means it
  std::uint8_t value = 0;  // as it is on the line
  bool is_dropped = false;
  bool has_broken_stop_bit = false;  // its first one is dominant
  Time start{};
  CharacterFormat format;

  WireEnd end() const { return sender == Sender::sr ? WireEnd::remote : WireEnd::power_module; }
  Time quiet_from() const { return start + (has_broken_stop_bit ? 10 : 9) * format.bit; }  // recessive from here on
  bool is_dominant(int bit) const {
    return bit == 0 || (bit <= 8 && (value >> (bit - 1) & 1) == 0) || (bit == 9 && has_broken_stop_bit);
  }
  bool is_dominant_at(Time time) const {
    return start <= time && time < quiet_from() && is_dominant(static_cast<int>((time - start) / format.bit));
  }
};

// The latest time during which something was so; without an end while it still is.
struct Spell {
  static constexpr Time never = Time::max();

  Time from = never;
  Time until = never;

  bool is_on() const { return from != never && until == never; }
  void begin(Time now) { *this = {now, never}; }
  void finish(Time now) { until = now; }

  bool holds_at(Time time) const { return from <= time && time < until; }
  bool touches(Time begin, Time end) const { return from <= end && begin < until; }
  bool covers(Time begin, Time end) const { return from <= begin && end <= until; }
};

// When a receiver of this clock, in a character since `edge`, has taken the last sample of its first stop bit; from
// then on it looks for the next edge.
Time sampled_by(Time edge, Time bit);
// And when it has looked at the start bit.
Time confirmed_by(Time edge, Time bit);

class Line {
 public:
  // Nothing passes between the ends; nothing is on the line at all (SB-1.3).
  Spell cut;
  Spell wake;

  // In order of their start, which lies at or after the moment up to which edges have been asked for.
  void add(const Character& character);
  const std::vector<Character>& characters() const { return characters_; }
  // Drops the oldest characters as long as they were over before `time`; tells how many.
  std::size_t forget_before(Time time);

  bool is_recessive(WireEnd at, Time time) const;
  // The first falling edge at or after `from`, as far as is known; Time::max() if there is none.
  Time first_edge(WireEnd at, Time from) const;
  // What a receiver hears that was started by `edge`; nothing if that was no start bit.
  std::optional<Reception> sample(WireEnd at, Time edge, Time bit) const;

 private:
  bool is_silenced(WireEnd at, const Character& character) const;
  bool is_plain(WireEnd at, const Character& character) const;
  bool is_alone(const Character& character, Time until) const;
  const Character* only_character(WireEnd at, Time edge, Time bit) const;
  Time search_edge(WireEnd at, Time from) const;
  bool majority(WireEnd at, Time edge, Time bit, int number) const;

  std::vector<Character> characters_;
};

}  // namespace simulation
