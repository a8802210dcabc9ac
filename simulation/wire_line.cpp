#include "simulation/wire_line.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr int stop_bit = 9;  // the start bit is bit 0

// A UART takes 16 samples of a bit; the middle three decide.
constexpr int first_vote = 8;
constexpr int last_vote = 10;

constexpr Time sample_time(Time edge, Time bit, int number, int sample) {
  return edge + bit * (16 * number + sample) / 16;
}

// Closer than 2 %, every vote falls into its bit whatever the value.
bool are_alike(Time one, Time other) {
  const Time difference = one > other ? one - other : other - one;
  return difference * 50 <= other;
}

}  // namespace

Time sampled_by(Time edge, Time bit) {
  return sample_time(edge, bit, stop_bit, last_vote);
}

Time confirmed_by(Time edge, Time bit) {
  return sample_time(edge, bit, 0, last_vote);
}

void Line::add(const Character& character) {
  auto place = characters_.end();
  while (place != characters_.begin() && std::prev(place)->start > character.start) {
    --place;
  }
  characters_.insert(place, character);
}

std::size_t Line::forget_before(Time time) {
  const auto kept = std::find_if(characters_.begin(), characters_.end(),
                                 [&](const Character& character) { return character.quiet_from() >= time; });
  const auto count = static_cast<std::size_t>(kept - characters_.begin());
  characters_.erase(characters_.begin(), kept);
  return count;
}

bool Line::is_recessive(WireEnd at, Time time) const {
  return wake.holds_at(time) || std::none_of(characters_.begin(), characters_.end(), [&](const Character& character) {
           const bool is_far = character.end() != at && cut.holds_at(time);
           return !character.is_dropped && !is_far && character.is_dominant_at(time);
         });
}

// Not heard at all, as things stand.
bool Line::is_silenced(WireEnd at, const Character& character) const {
  return character.is_dropped || wake.covers(character.start, character.quiet_from()) ||
         (character.end() != at && cut.covers(character.start, character.quiet_from()));
}

// Heard whole, unless somebody else speaks.
bool Line::is_plain(WireEnd at, const Character& character) const {
  return !character.is_dropped && !wake.touches(character.start, character.quiet_from()) &&
         (character.end() == at || !cut.touches(character.start, character.quiet_from()));
}

bool Line::is_alone(const Character& character, Time until) const {
  for (const Character& other : characters_) {
    if (other.start >= until) {
      return true;
    }
    if (&other != &character && other.quiet_from() > character.start) {
      return false;
    }
  }
  return true;
}

Time Line::first_edge(WireEnd at, Time from) const {
  for (const Character& character : characters_) {
    if (character.quiet_from() <= from || is_silenced(at, character)) {
      continue;
    }
    const bool begins_from_idle = character.start >= from && is_plain(at, character);
    return begins_from_idle ? character.start : search_edge(at, from);
  }
  return Time::max();
}

// The edge may be one inside a character, or a character may come to be heard in the middle of a bit.
Time Line::search_edge(WireEnd at, Time from) const {
  Time first = Time::max();
  const auto consider = [&](Time time) {
    if (from <= time && time < first && is_recessive(at, time - 1ns) && !is_recessive(at, time)) {
      first = time;
    }
  };
  for (const Character& character : characters_) {
    for (int bit = 0; bit <= stop_bit; ++bit) {
      if (character.is_dominant(bit) && (bit == 0 || !character.is_dominant(bit - 1))) {
        consider(character.start + bit * character.format.bit);
      }
    }
  }
  consider(wake.until);
  consider(cut.until);
  return first;
}

std::optional<Reception> Line::sample(WireEnd at, Time edge, Time bit) const {
  Reception reception;
  reception.at = sampled_by(edge, bit);
  if (const Character* character = only_character(at, edge, bit)) {
    reception.value = character->value;
    return reception;
  }
  if (majority(at, edge, bit, 0)) {
    return std::nullopt;
  }
  for (int number = 1; number < stop_bit; ++number) {
    reception.value |= static_cast<std::uint8_t>(majority(at, edge, bit, number) << (number - 1));
  }
  reception.framing_error = !majority(at, edge, bit, stop_bit);
  return reception;
}

// The character that begins with the edge, if it can only be heard as it is.
const Character* Line::only_character(WireEnd at, Time edge, Time bit) const {
  for (const Character& character : characters_) {
    if (character.start >= edge) {
      const bool is_clear = character.start == edge && !character.has_broken_stop_bit &&
                            are_alike(character.format.bit, bit) && is_plain(at, character) &&
                            is_alone(character, sampled_by(edge, bit));
      return is_clear ? &character : nullptr;
    }
  }
  return nullptr;
}

bool Line::majority(WireEnd at, Time edge, Time bit, int number) const {
  int recessive = 0;
  for (int vote = first_vote; vote <= last_vote; ++vote) {
    recessive += is_recessive(at, sample_time(edge, bit, number, vote)) ? 1 : 0;
  }
  return recessive >= 2;
}

}  // namespace simulation
