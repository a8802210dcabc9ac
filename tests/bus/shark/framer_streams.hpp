// Random streams for the framer, and its verdicts beside the reference's: a stream is bytes of an honest conversation,
// then mutated, or plain soup; its gaps lie densely where 3 ms are decided. Everything follows from one number.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "bus/shark/framer.hpp"
#include "tests/bus/shark/reference_framer.hpp"

namespace reference {

// SplitMix64: small, quick, and any number is a good seed.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t roll() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
    z = (z ^ z >> 27) * 0x94D049BB133111EBU;
    return z ^ z >> 31;
  }
  unsigned below(unsigned limit) { return static_cast<unsigned>(roll() % limit); }
  bool one_in(unsigned count) { return below(count) == 0; }

 private:
  std::uint64_t state_;
};

// How the loop around the framer asks it for the time: every half millisecond from some phase on, and when the line has
// been silent long enough, as a timer tells it.
struct Polling {
  unsigned every = 500;
  unsigned phase = 0;
  unsigned after_byte = 3045;
};

struct Case {
  Stream stream;
  Polling polling;
};

// ---- making streams

constexpr unsigned back_to_back = 286;

// One byte in `calm` has a gap before it that matters.
inline unsigned make_gap(Dice& dice, unsigned calm) {
  switch (dice.below(4 * calm)) {
    case 0:
      return 3030 + dice.below(12);  // where the verdict turns
    case 1:
      return 2900 + dice.below(300);
    case 2:
      return back_to_back + dice.below(2600);
    case 3:
      return dice.one_in(8) ? 3036 + dice.below(120'000) : 3100 + dice.below(1000);
    default:
      return back_to_back + dice.below(3);
  }
}

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : dice_(seed), calm_(dice_.one_in(2) ? 1000 : 5 + dice_.below(40)) {}

  Case write();

 private:
  void add(unsigned value, bool is_spoiled = false);
  void add_packet();
  void add_soup();
  void mutate();
  void delay(std::size_t from, std::uint64_t by);

  Dice dice_;
  unsigned calm_;
  Stream stream_;
};

inline void Writer::add(unsigned value, bool is_spoiled) {
  const std::uint64_t last = stream_.empty() ? dice_.below(70'000) : stream_.back().at;
  stream_.push_back({static_cast<std::uint8_t>(value), is_spoiled, last + make_gap(dice_, calm_)});
}

inline void Writer::add_packet() {
  const unsigned length = dice_.one_in(3) ? 7 : 1 + dice_.below(8);
  unsigned sum = (length - 1) << 4 | dice_.below(16);
  add(sum);
  for (unsigned i = 0; i < length; ++i) {
    const unsigned value = 0x80 + dice_.below(0x80);
    add(value);
    sum += value;
  }
  add(0xFF - sum % 0x80);
}

inline void Writer::add_soup() {
  for (unsigned left = 1 + dice_.below(12); left > 0; --left) {
    const unsigned value = dice_.one_in(6) ? 0x0F : dice_.below(256);
    add(value, dice_.one_in(12));
  }
}

// What noise does to a stream.
inline void Writer::mutate() {
  const std::size_t place = dice_.below(static_cast<unsigned>(stream_.size()));
  Byte& byte = stream_[place];
  const auto here = stream_.begin() + static_cast<std::ptrdiff_t>(place);
  switch (dice_.below(6)) {
    case 0:
      stream_.erase(here);
      break;
    case 1:
      byte.value = static_cast<std::uint8_t>(byte.value ^ 1U << dice_.below(8));
      break;
    case 2:
      stream_.insert(here, byte);
      delay(place + 1, back_to_back);
      break;
    case 3:
      delay(place, 2600 + dice_.below(600));
      break;
    case 4:
      byte.is_spoiled = true;
      break;
    default:
      byte.value = static_cast<std::uint8_t>(dice_.below(256));
      break;
  }
}

inline void Writer::delay(std::size_t from, std::uint64_t by) {
  for (std::size_t i = from; i < stream_.size(); ++i) {
    stream_[i].at += by;
  }
}

inline Case Writer::write() {
  const std::size_t size = 20 + dice_.below(40);
  const bool is_soup = dice_.one_in(5);
  while (stream_.size() < size) {
    if (is_soup || dice_.one_in(20)) {
      add_soup();
    } else {
      add_packet();
    }
    if (dice_.one_in(3)) {
      add(0x0F);
    }
  }
  for (unsigned left = dice_.below(5); left > 0; --left) {
    mutate();
  }
  return {stream_, {500, dice_.below(500), dice_.one_in(2) ? 3036 + dice_.below(300) : 100'000'000}};
}

inline Case make_case(std::uint64_t seed) {
  return Writer(seed).write();
}

// ---- the product's verdicts in the reference's words

class ProductRun {
 public:
  explicit ProductRun(const Case& played) : polling_(played.polling), outcomes_(played.stream.size() + 1) {
    for (const Byte& byte : played.stream) {
      pass_until(byte.at);
      const bus::shark::Verdict verdict = framer_.feed({byte.value, byte.is_spoiled, stamp(byte.at)});
      note(verdict);
      if (verdict.what == bus::shark::Verdict::What::frame) {
        outcomes_[place_].packet = packet();
      }
      outcomes_[place_].finished = verdict.what == bus::shark::Verdict::What::finished;
      ++place_;
      now_ = last_ = byte.at;
    }
    pass_until(now_ + 10'000);
  }

  const std::vector<Outcome>& outcomes() const { return outcomes_; }
  // Verdicts that no stream may bring, such as the same silence twice.
  bool is_sane() const { return is_sane_; }

 private:
  static base::Stamp stamp(std::uint64_t at) { return base::Stamp(static_cast<std::uint16_t>(at)); }

  // Every poll before that moment. After the first byte only: there is nothing to end before.
  void pass_until(std::uint64_t until) {
    if (place_ == 0) {
      return;
    }
    bool is_timer_set = true;
    for (;;) {
      std::uint64_t next = (now_ - polling_.phase + polling_.every) / polling_.every * polling_.every + polling_.phase;
      if (is_timer_set && last_ + polling_.after_byte <= next) {
        next = last_ + polling_.after_byte;
        is_timer_set = false;
      }
      if (next >= until) {
        return;
      }
      now_ = next;
      const bus::shark::Verdict verdict = framer_.poll(stamp(now_));
      is_sane_ = is_sane_ && verdict.what == bus::shark::Verdict::What::nothing;
      note(verdict);
    }
  }

  void note(const bus::shark::Verdict& verdict) {
    Outcome& outcome = outcomes_[place_];
    is_sane_ = is_sane_ && !(verdict.silence && outcome.silence);
    outcome.corrupt += verdict.corrupt;
    outcome.silence = outcome.silence || verdict.silence;
  }

  Packet packet() const {
    const bus::shark::Frame& frame = framer_.frame();
    Packet packet{frame.type, {}};
    for (std::uint8_t i = 0; i < frame.length; ++i) {
      packet.data.push_back(frame.data[i]);
    }
    return packet;
  }

  Polling polling_;
  bus::shark::Framer framer_;
  std::vector<Outcome> outcomes_;
  std::size_t place_ = 0;  // of the next byte
  std::uint64_t now_ = 0;
  std::uint64_t last_ = 0;
  bool is_sane_ = true;
};

inline bool do_agree(const Case& played) {
  if (played.stream.empty()) {
    return true;
  }
  const ProductRun product(played);
  return product.is_sane() && product.outcomes() == Reading(played.stream).outcomes();
}

// ---- a disagreement, made small

namespace shrinking {

// Without `count` bytes from `from` on; what follows moves up, its gaps kept.
inline Case without(const Case& played, std::size_t from, std::size_t count) {
  Case less = played;
  Stream& stream = less.stream;
  const std::size_t until = from + count;
  const std::uint64_t shift = until < stream.size() ? stream[until].at - stream[from].at : 0;
  for (std::size_t i = until; i < stream.size(); ++i) {
    stream[i].at -= shift;
  }
  stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(from), stream.begin() + static_cast<std::ptrdiff_t>(until));
  return less;
}

inline Case with_plain_gap(const Case& played, std::size_t place) {
  Case plainer = played;
  const std::uint64_t gap = plainer.stream[place].at - plainer.stream[place - 1].at;
  for (std::size_t i = place; i < plainer.stream.size(); ++i) {
    plainer.stream[i].at = plainer.stream[i].at - gap + back_to_back;
  }
  return plainer;
}

inline bool take_if_smaller(Case& best, const Case& attempt) {
  if (do_agree(attempt)) {
    return false;
  }
  best = attempt;
  return true;
}

inline bool shrink_once(Case& best) {
  for (std::size_t count = best.stream.size() / 2; count > 0; count /= 2) {
    for (std::size_t from = 0; from + count <= best.stream.size(); ++from) {
      if (take_if_smaller(best, without(best, from, count))) {
        return true;
      }
    }
  }
  for (std::size_t i = 0; i < best.stream.size(); ++i) {
    if (i > 0 && best.stream[i].at - best.stream[i - 1].at != back_to_back &&
        take_if_smaller(best, with_plain_gap(best, i))) {
      return true;
    }
    for (const std::uint8_t plain : {std::uint8_t{0x00}, std::uint8_t{0x80}}) {
      Case attempt = best;
      attempt.stream[i].value = plain;
      attempt.stream[i].is_spoiled = false;
      const bool is_plainer = best.stream[i].is_spoiled || best.stream[i].value > plain;
      if (is_plainer && take_if_smaller(best, attempt)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace shrinking

inline Case shrink(Case played) {
  while (shrinking::shrink_once(played)) {
  }
  return played;
}

// Literal bytes with times, both verdicts beside.
inline std::string tell(const Outcome& outcome) {
  std::string text;
  for (int i = 0; i < outcome.corrupt; ++i) {
    text += "corrupt ";
  }
  text += outcome.silence ? "silence " : "";
  text += outcome.finished ? "finished " : "";
  if (outcome.packet) {
    text += "packet " + std::to_string(outcome.packet->type) + ":";
    for (const std::uint8_t value : outcome.packet->data) {
      char hex[4];
      std::snprintf(hex, sizeof hex, " %02X", value);
      text += hex;
    }
  }
  return text.empty() ? "-" : text;
}

inline std::string tell(const Case& played) {
  const ProductRun product(played);
  const Reading reading(played.stream);
  std::string text = "// polled every " + std::to_string(played.polling.every) + " us from " +
                     std::to_string(played.polling.phase) + " on, and " + std::to_string(played.polling.after_byte) +
                     " us after each byte\n";
  char line[256];
  for (std::size_t i = 0; i <= played.stream.size(); ++i) {
    if (i < played.stream.size()) {
      const Byte& byte = played.stream[i];
      std::snprintf(line, sizeof line, "{0x%02X, %s, %llu},", byte.value, byte.is_spoiled ? "true" : "false",
                    static_cast<unsigned long long>(byte.at));
    } else {
      std::snprintf(line, sizeof line, "// 10 ms of silence");
    }
    const Outcome& ours = product.outcomes()[i];
    const Outcome& theirs = reading.outcomes()[i];
    char whole[512];
    std::snprintf(whole, sizeof whole, "%-26s // framer: %-20s reference: %-20s%s\n", line, tell(ours).c_str(),
                  tell(theirs).c_str(), ours == theirs ? "" : " <<");
    text += whole;
  }
  return text;
}

}  // namespace reference
