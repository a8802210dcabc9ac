// The sequences of docs/bus.md that are marked as played, played: what the others say is heard byte for byte, and what
// the page claims that we say is what we say. How they are written is told in tests/tools/bus_page.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/bench.hpp"

namespace {

using namespace support;

struct Line {
  int number;
  std::string who;       // "SR", or "wait"
  bool is_like = false;  // only types and lengths count
  int times = 1;
  Bytes bytes;
  Microseconds wait = 0;
};

struct Sequence {
  int number;
  std::string given;
  std::vector<Line> lines;
};

// "SR x5: 60 C0 .. | caption", "wait 61 ms | caption"; notes ("SPM * ...") are not played.
bool read_line(const std::string& text, Line& line) {
  std::istringstream words(text.substr(0, text.find('|')));
  std::string word;
  words >> line.who;
  if (line.who == "wait") {
    std::string unit;
    words >> line.wait >> unit;
    line.wait *= unit == "s" ? 1000000 : 1000;
    return true;
  }
  bool is_head = line.who.back() != ':';
  line.who = line.who.substr(0, line.who.find(':'));
  while (words >> word) {
    if (!is_head) {
      line.bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
      continue;
    }
    if (word == "*") {
      return false;
    }
    is_head = word.back() != ':';
    line.is_like = line.is_like || word.rfind("like", 0) == 0;
    if (word[0] == 'x') {
      line.times = std::stoi(word.substr(1));
    }
  }
  return true;
}

std::vector<Sequence> played() {
  std::ifstream page(PILOTFISH_BUS_PAGE);
  std::vector<Sequence> sequences;
  bool is_inside = false;
  int number = 0;
  for (std::string text; std::getline(page, text);) {
    ++number;
    const std::size_t colon = text.find(": ");
    if (text.rfind("@sequence", 0) == 0 && colon != std::string::npos) {
      sequences.push_back({number, text.substr(colon + 2), {}});
      is_inside = true;
    } else if (text == "@end") {
      is_inside = false;
    } else if (Line line{number, "", false, 1, {}, 0}; is_inside && !text.empty() && read_line(text, line)) {
      sequences.back().lines.push_back(line);
    }
  }
  return sequences;
}

Bench bench_in(const std::string& state) {
  if (state == "new") {
    return Bench();
  }
  if (state == "driving") {
    return Bench::driving();
  }
  REQUIRE(state == "ready");
  return Bench::ready();
}

// Start bytes and TF: what is said without what it says.
Bytes outline(const Bytes& turn) {
  Bytes starts;
  for (std::size_t at = 0; at < turn.size(); at += turn[at] == 0x0F ? 1U : turn[at] / 16U + 3U) {
    starts.push_back(turn[at]);
  }
  return starts;
}

std::string words_of(const Bytes& bytes) {
  std::string words;
  for (const std::uint8_t byte : bytes) {
    words += "0123456789ABCDEF"[byte / 16U];
    words += "0123456789ABCDEF"[byte % 16U];
    words += ' ';
  }
  return words;
}

class Player {
 public:
  explicit Player(Bench bench) : bench_(std::move(bench)), end_(bench_.now()), said_(bench_.turns().size()) {}

  void play(const Line& line) {
    CAPTURE(line.number);
    if (line.who == "wait") {
      settle();
      bench_.run_until(heard_ + line.wait);
      CHECK(bench_.turns().size() == said_);
      end_ = bench_.now();
    } else if (line.who == "SPM") {
      bench_.run_ms(8);
      REQUIRE(bench_.turns().size() == said_ + awaited_);
      if (line.is_like) {
        CHECK(words_of(outline(bench_.last_turn())) == words_of(outline(line.bytes)));
      } else {
        CHECK(words_of(bench_.last_turn()) == words_of(line.bytes));
      }
      said_ += awaited_;
      awaited_ = 0;
    } else {
      hear(line);
    }
  }

  // Nothing was said that the page does not claim.
  void settle() {
    CHECK(bench_.turns().size() == said_);
    awaited_ = 0;
  }

  void finish() {
    bench_.run_until(std::max(end_, bench_.now() + 8000));
    settle();
  }

 private:
  void hear(const Line& line) {
    for (int i = 0; i < line.times; ++i) {
      bench_.run_until(end_);
      if (i == 0) {
        settle();
      }
      end_ = bench_.now() + 20000;
      bench_.hear(line.bytes);
      heard_ = bench_.now();
    }
    awaited_ = static_cast<std::size_t>(line.times);
  }

  Bench bench_;
  Microseconds end_;        // of the cycle
  Microseconds heard_ = 0;  // when the last turn of others ended; `wait` counts from there
  std::size_t said_;        // turns that the page has claimed
  std::size_t awaited_ = 0;
};

TEST_CASE("what docs/bus.md says that we say is what we say", "[SB-2.7][SB-2.13][SB-2.15][SB-3.2][SB-3.4][SB-4.1]") {
  const std::vector<Sequence> sequences = played();
  REQUIRE(sequences.size() >= 8);
  for (const Sequence& sequence : sequences) {
    CAPTURE(sequence.number);
    REQUIRE(sequence.lines.size() >= 1);
    Player player(bench_in(sequence.given));
    for (const Line& line : sequence.lines) {
      player.play(line);
    }
    player.finish();
  }
}

}  // namespace
