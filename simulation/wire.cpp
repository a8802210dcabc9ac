#include "simulation/wire.hpp"

#include <algorithm>

namespace simulation {
namespace {

constexpr Time nominal_bit = CharacterFormat{}.bit;
constexpr Time memory = 1ms;  // longer than any character

}  // namespace

void Wire::attach(WireEnd end, WireNode& node, Time now) {
  Ear ear;
  ear.node = &node;
  ear.end = end;
  ear.listens_from = now;
  seek(ear);
  ears_.push_back(ear);
}

void Wire::detach(const WireNode& node) {
  std::erase_if(ears_, [&](const Ear& ear) { return ear.node == &node; });
}

void Wire::send(Sender sender, std::uint8_t value, Time start, const CharacterFormat& format) {
  Character character{sender, value, value, false, false, start, format};
  faults_.pass(character);
  put(character);
}

void Wire::put(const Character& character) {
  line_.add(character);
  for (Ear& ear : ears_) {
    if (character.start < ear.edge) {
      seek(ear);
    }
  }
}

void Wire::send(Sender sender, const std::vector<std::uint8_t>& values, Time start) {
  const CharacterFormat format;
  for (const std::uint8_t value : values) {
    send(sender, value, start, format);
    start += format.length();
  }
}

void Wire::hold_wake(bool asserted, Time now) {
  is_wake_held_ = asserted;
  set_wake(now);
}

void Wire::pulse_wake(Time now, Time span) {
  pulse_until_ = now + span;
  set_wake(now);
}

void Wire::set_wake(Time now) {
  const bool is_asserted = is_wake_held_ || pulse_until_ != never;
  if (is_asserted == is_wake_asserted()) {
    return;
  }
  if (is_asserted) {
    line_.wake.begin(now);
  } else {
    line_.wake.finish(now);
  }
  seek_anew(now);
  if (tell_wake_) {
    tell_wake_(is_asserted, now);
  }
}

void Wire::cut(Time now) {
  if (!is_cut()) {
    line_.cut.begin(now);
    seek_anew(now);
  }
}

void Wire::mend(Time now) {
  if (is_cut()) {
    line_.cut.finish(now);
    seek_anew(now);
  }
}

void Wire::babble(Time now, Time span, double share) {
  const auto length = static_cast<double>(CharacterFormat{}.length().count());
  begin_noise(now, span, Time{static_cast<Time::rep>(length / share)}, false);
}

void Wire::jam(Time now, Time span) {
  begin_noise(now, span, CharacterFormat{}.length(), true);
}

void Wire::begin_noise(Time now, Time span, Time spacing, bool is_jam) {
  if (babble_at_ == never) {
    babble_at_ = now;
  }
  babble_until_ = now + span;
  babble_spacing_ = spacing;
  is_jammed_ = is_jam;
}

void Wire::babble_on() {
  const Time start = babble_at_;
  babble_at_ += babble_spacing_;
  if (babble_at_ >= babble_until_) {
    babble_at_ = never;
  }
  if (is_jammed_) {
    put(Character{Sender::noise, 0, 0, false, true, start, {}});
  } else {
    send(Sender::noise, static_cast<std::uint8_t>(random_()), start);
  }
}

Time Wire::next_time() const {
  Time next = std::min(babble_at_, pulse_until_);
  for (const Ear& ear : ears_) {
    next = std::min(next, ear.due);
  }
  return next;
}

void Wire::advance(Time now) {
  for (Time next = next_time(); next <= now; next = next_time()) {
    if (babble_at_ == next) {
      babble_on();
    }
    for (Ear& ear : ears_) {
      if (ear.due == next) {
        finish_character(ear);
      }
    }
    if (pulse_until_ == next) {
      pulse_until_ = never;
      set_wake(next);
    }
  }
  report_until(now);
}

// ---- the receivers

void Wire::seek(Ear& ear) const {
  ear.edge = line_.first_edge(ear.end, ear.listens_from);
  ear.due = never;
  if (ear.edge != never) {
    ear.bit = ear.node->bit_time();
    ear.due = sampled_by(ear.edge, ear.bit);
  }
}

// The line has changed from now on. An edge that has been is kept: its character is being sampled.
void Wire::seek_anew(Time now) {
  for (Ear& ear : ears_) {
    if (ear.edge >= now) {
      ear.listens_from = std::max(ear.listens_from, now);
      seek(ear);
    }
  }
}

void Wire::finish_character(Ear& ear) {
  const auto reception = line_.sample(ear.end, ear.edge, ear.bit);
  const bool is_heard = reception && !line_.wake.holds_at(ear.due);  // SB-1.3
  ear.listens_from = reception ? ear.due : confirmed_by(ear.edge, ear.bit);
  seek(ear);
  if (is_heard) {
    ear.node->hear(*reception);
  }
}

// ---- the observer

void Wire::report_until(Time now) {
  const auto& characters = line_.characters();
  while (reported_ < characters.size() && sampled_by(characters[reported_].start, nominal_bit) <= now) {
    report(characters[reported_++]);
  }
  reported_ -= line_.forget_before(now - memory);
}

void Wire::report(const Character& character) const {
  if (!report_) {
    return;
  }
  BusByte byte;
  byte.start = character.start;
  byte.end = character.start + character.format.length();
  byte.sender = character.sender;
  byte.sent = character.sent;
  byte.lost = character.is_dropped || line_.wake.holds_at(character.start) ||
              (character.end() == WireEnd::remote && line_.cut.holds_at(character.start));
  if (!byte.lost) {
    const auto reception = line_.sample(WireEnd::power_module, character.start, nominal_bit);
    byte.heard = reception ? reception->value : 0;
    byte.spoiled = !reception || reception->framing_error;
  }
  report_(byte);
}

}  // namespace simulation
