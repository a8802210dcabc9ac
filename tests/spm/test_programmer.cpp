// The programmer's two streams, first by themselves, then through a power module on its bench.
#include "spm/programmer.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "tests/support/bench.hpp"

namespace {

using namespace support;
using bus::shark::HhpData;
using bus::shark::Turn;
using spm::EventCode;
using spm::Programmer;

// ---- by itself

HhpData data_of(const std::string& text) {
  HhpData data;
  for (const char character : text) {
    data.characters[data.count++] = static_cast<std::uint8_t>(character);
  }
  return data;
}

// Characters of the HHP packets in these bytes of ours.
std::string shown_by(const Bytes& turn) {
  std::string text;
  for (std::size_t at = 0; at < turn.size() && turn[at] != 0x0F; at += turn[at] / 16U + 3U) {
    if (turn[at] % 16 == 3) {
      for (std::size_t i = 0; i <= turn[at] / 16U; ++i) {
        text += static_cast<char>(turn[at + 1 + i] % 128);
      }
    }
  }
  return text;
}

std::string turn_of(Programmer& programmer, bool may_send = true) {
  Turn turn;
  turn.open();
  programmer.add_to(turn, may_send);
  turn.close();
  return shown_by(Bytes(turn.bytes().begin(), turn.bytes().end()));
}

std::string taken_from(Programmer& programmer) {
  std::string text;
  for (char character = 0; programmer.take(character);) {
    text += character;
  }
  return text;
}

TEST_CASE("what the programmer sends is read in order, packet by packet", "[SB-02.1]") {
  Programmer programmer;
  CHECK(programmer.hear(data_of("one ")) == 0);
  CHECK(programmer.hear(data_of("two")) == 0);
  CHECK(programmer.has_work());
  CHECK(taken_from(programmer) == "one two");
  CHECK_FALSE(programmer.has_work());
  CHECK(programmer.hear(data_of("!")) == 0);
  CHECK(taken_from(programmer) == "!");
}

TEST_CASE("64 characters are kept unread, the 65th is lost and counted", "[SB-02.1]") {
  Programmer programmer;
  for (int i = 0; i < 8; ++i) {
    CHECK(programmer.hear(data_of("ABCDEFGH")) == 0);
  }
  CHECK_FALSE(programmer.is_losing());
  CHECK(programmer.hear(data_of("x")) == 1);
  CHECK(programmer.is_losing());
  CHECK(programmer.lost() == 1);
  char character = 0;
  CHECK(programmer.take(character));
  CHECK(programmer.hear(data_of("12345678")) == 7);  // the first of them had room
  CHECK(programmer.lost() == 8);
  const std::string rest = taken_from(programmer);
  CHECK(rest.size() == 64);
  CHECK(rest.substr(0, 7) == "BCDEFGH");
  CHECK(rest.back() == '1');
}

TEST_CASE("characters are being lost until all that was kept has been read", "[SB-02.1]") {
  Programmer programmer;
  for (int i = 0; i < 9; ++i) {
    programmer.hear(data_of("ABCDEFGH"));
  }
  char character = 0;
  for (int i = 0; i < 63; ++i) {
    programmer.take(character);
    CHECK(programmer.is_losing());
  }
  programmer.take(character);
  CHECK_FALSE(programmer.is_losing());
  CHECK(programmer.lost() == 8);
}

TEST_CASE("the count of lost characters stops at 65535", "[SB-02.1]") {
  Programmer programmer;
  for (long i = 0; i < 8 + 65535 / 8; ++i) {
    programmer.hear(data_of("ABCDEFGH"));
  }
  CHECK(programmer.lost() == 65528);
  programmer.hear(data_of("1234567"));
  CHECK(programmer.lost() == 65535);
  programmer.hear(data_of("1"));
  CHECK(programmer.lost() == 65535);
}

TEST_CASE("a turn takes up to 8 characters, the oldest first, once each", "[SB-03.1]") {
  Programmer programmer;
  for (const char character : std::string("Pilotfish 1.0")) {
    CHECK(programmer.put(character));
  }
  programmer.prepare();
  CHECK(turn_of(programmer) == "Pilotfis");
  programmer.left();
  programmer.prepare();
  CHECK(turn_of(programmer) == "h 1.0");
  programmer.left();
  programmer.prepare();
  CHECK(turn_of(programmer).empty());
  CHECK(programmer.room() == 128);
}

TEST_CASE("nothing goes into a turn that must not hold it", "[SB-03.1]") {
  Programmer programmer;
  programmer.put('a');
  programmer.prepare();
  CHECK(turn_of(programmer, false).empty());
  programmer.left();
  CHECK(programmer.room() == 127);
  CHECK(turn_of(programmer, true) == "a");
}

TEST_CASE("characters of a turn that was never said go into the next one", "[SB-03.1][SB-2.9]") {
  Programmer programmer;
  for (const char character : std::string("12345678abc")) {
    programmer.put(character);
  }
  programmer.prepare();
  CHECK(turn_of(programmer) == "12345678");
  programmer.prepare();
  CHECK(turn_of(programmer) == "12345678");
  CHECK(turn_of(programmer, false).empty());
  programmer.left();  // without them
  CHECK(turn_of(programmer) == "12345678");
  programmer.left();
  programmer.left();
  programmer.prepare();
  CHECK(turn_of(programmer) == "abc");
}

TEST_CASE("a packet grows until its turn is made, not after", "[SB-03.1]") {
  Programmer programmer;
  programmer.put('a');
  programmer.prepare();
  programmer.put('b');
  CHECK(programmer.has_work());
  programmer.prepare();
  CHECK_FALSE(programmer.has_work());
  CHECK(turn_of(programmer) == "ab");
  programmer.put('c');
  programmer.prepare();
  programmer.left();
  programmer.prepare();
  CHECK(turn_of(programmer) == "c");
}

TEST_CASE("128 characters wait to be sent, the next is refused", "[SB-03.1]") {
  Programmer programmer;
  for (int i = 0; i < 128; ++i) {
    CHECK(programmer.room() == 128 - i);
    CHECK(programmer.put('x'));
  }
  CHECK(programmer.room() == 0);
  CHECK_FALSE(programmer.put('y'));
}

TEST_CASE("codes above 0x7F are refused, all others are sent", "[SB-03.2]") {
  for (int code = 0; code < 256; ++code) {
    Programmer programmer;
    CAPTURE(code);
    CHECK(programmer.put(static_cast<char>(code)) == (code <= 0x7F));
    programmer.prepare();
    CHECK(turn_of(programmer) == (code <= 0x7F ? std::string(1, static_cast<char>(code)) : std::string()));
  }
}

TEST_CASE("clearing forgets both streams, but not how much was lost") {
  Programmer programmer;
  for (int i = 0; i < 9; ++i) {
    programmer.hear(data_of("ABCDEFGH"));
  }
  programmer.put('a');
  programmer.prepare();
  CHECK(turn_of(programmer) == "a");
  programmer.clear();
  CHECK(taken_from(programmer).empty());
  CHECK(turn_of(programmer).empty());
  CHECK(programmer.room() == 128);
  CHECK_FALSE(programmer.is_losing());
  CHECK_FALSE(programmer.has_work());
  CHECK(programmer.lost() == 8);
}

// ---- the echo

TEST_CASE("the echo shows printable characters, the programmer's own four, and the carriage return as a new line") {
  for (int code = 0; code < 128; ++code) {
    Programmer programmer;
    programmer.hear(data_of(std::string(1, static_cast<char>(code))));
    spm::echo(programmer);
    programmer.prepare();
    CAPTURE(code);
    const bool is_shown = (code >= 32 && code <= 126) || (code >= 0x10 && code <= 0x13);
    CHECK(turn_of(programmer) == (code == 13 ? "\r\n" : std::string(is_shown ? 1 : 0, static_cast<char>(code))));
  }
}

TEST_CASE("the echo does four characters at a time and reads none that it could not show") {
  Programmer programmer;
  programmer.hear(data_of("ABCDEFGH"));
  spm::echo(programmer);
  CHECK(programmer.room() == 124);
  while (programmer.room() > 1) {
    programmer.put('.');
  }
  spm::echo(programmer);
  CHECK(programmer.room() == 1);
  CHECK(taken_from(programmer) == "EFGH");
}

// ---- on the bus

const Bytes quiet = wire::at_rest;                                        // the remote has no room for HHP data
const Bytes ready{0x60, 0xC0, 0xC0, 0x80, 0x80, 0x80, 0x84, 0x80, 0x9B};  // it has

Bytes typed(const std::string& text) {
  Bytes packet{static_cast<std::uint8_t>(16 * (text.size() - 1) + 2)};
  for (const char character : text) {
    packet.push_back(static_cast<std::uint8_t>(128 + character));
  }
  return sealed(packet);
}

std::string shown_since(const Bench& bench, std::size_t turn) {
  std::string text;
  for (; turn < bench.turns().size(); ++turn) {
    text += shown_by(bench.turns()[turn].bytes);
  }
  return text;
}

// So many characters, no two the same within 90.
std::string long_text(int length) {
  std::string text;
  for (int i = 0; i < length; ++i) {
    text += static_cast<char>('!' + i % 90);
  }
  return text;
}

void type(Bench& bench, const std::string& text, const Bytes& general) {
  for (std::size_t at = 0; at < text.size(); at += 8) {
    bench.cycle(general + typed(text.substr(at, 8)));
  }
}

TEST_CASE("what is typed comes back in literal packets, behind the general", "[SB-02.1][SB-03.1][SB-2.7]") {
  Bench bench = Bench::ready();
  // "Hi" and CR; type 2, 3 characters: 22 + C8 + E9 + 8D = 260, of which 60 counts.
  bench.cycle(ready + Bytes{0x22, 0xC8, 0xE9, 0x8D, 0x9F});
  CHECK(bench.last_turn().size() == 10);
  bench.cycle(ready);
  const Bytes turn = bench.last_turn();
  REQUIRE(turn.size() == 16);
  CHECK(turn[0] == 0x61);
  // "Hi", CR, LF; type 3, 4 characters: 33 + C8 + E9 + 8D + 8A = 2FB, of which 7B counts.
  CHECK(Bytes(turn.begin() + 9, turn.end()) == Bytes{0x33, 0xC8, 0xE9, 0x8D, 0x8A, 0x84, 0x0F});
  bench.cycle(ready, 5);
  CHECK(shown_since(bench, 0) == "Hi\r\n");
}

TEST_CASE("a thousand characters in packets of any length come back in order, none twice, none missing",
          "[SB-02.1][SB-03.1][SB-2.9]") {
  Bench bench = Bench::ready();
  const std::string text = long_text(1000);
  std::mt19937 random(7);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = std::min<std::size_t>(1 + random() % 8, text.size() - at);
    bench.cycle(ready + typed(text.substr(at, length)));
    at += length;
  }
  bench.cycle(ready, 5);
  CHECK(shown_since(bench, 0) == text);
  CHECK(bench.spm().programmer().lost() == 0);
  CHECK_FALSE(bench.has_event(EventCode::hhp_data_lost));
}

TEST_CASE("the flow-control bit counts in the answer to its own general", "[SB-03.1]") {
  Bench bench = Bench::ready();
  type(bench, long_text(64), quiet);
  CHECK(shown_since(bench, 0).empty());
  const auto shown_after = [&bench](const Bytes& general) {
    bench.cycle(general);
    return shown_by(bench.last_turn()).size();
  };
  CHECK(shown_after(quiet) == 0);
  CHECK(shown_after(ready) == 8);
  CHECK(shown_after(quiet) == 0);
  CHECK(shown_after(quiet) == 0);
  CHECK(shown_after(ready) == 8);
  CHECK(shown_after(ready) == 8);
  CHECK(shown_after(quiet) == 0);
  bench.cycle(ready, 10);
  CHECK(shown_since(bench, 0) == long_text(64));
}

TEST_CASE("100 characters reach the programmer in less than half a second", "[SB-03.1]") {
  Bench bench = Bench::ready();
  type(bench, long_text(100), quiet);
  const std::size_t before = bench.turns().size();
  const Microseconds start = bench.now();
  while (shown_since(bench, before).size() < 100) {
    bench.cycle(ready);
    REQUIRE(bench.now() - start < 500000);
  }
  CHECK(bench.turns().size() - before == 13);
  CHECK(bench.turns().back().end - start < 260000);
  CHECK(shown_since(bench, before) == long_text(100));
}

TEST_CASE("settings keep their pace while the programmer talks, and no turn lasts longer than 8.5 ms",
          "[SB-2.2][SB-0A.1]") {
  Bench bench = Bench::ready();
  const std::size_t first = bench.turns().size();
  const std::string text = long_text(8 * 250);
  type(bench, text, ready);
  bench.cycle(ready, 2);
  CHECK(shown_since(bench, first) == text);
  const Bytes settings{0x1A, 0xA5, 0xA7, 0x99};
  int with_both = 0;
  Microseconds last = bench.turns()[first].start;
  for (std::size_t i = first; i < bench.turns().size(); ++i) {
    const Spoken& turn = bench.turns()[i];
    CHECK(turn.end - turn.start <= 8500);
    CHECK(turn.bytes.size() <= 24);
    if (turn.bytes.size() >= 14 && Bytes(turn.bytes.end() - 5, turn.bytes.end() - 1) == settings) {
      CHECK(turn.start - last <= 1000000);
      last = turn.start;
      with_both += turn.bytes.size() == 24;
    }
  }
  CHECK(bench.turns().back().start - last <= 1000000);
  CHECK(with_both >= 4);
}

TEST_CASE("what finds no room is lost, counted, and logged once until all that was kept has been read", "[SB-02.1]") {
  Bench bench = Bench::ready();
  const std::uint16_t before = bench.spm().events().total();
  type(bench, long_text(184), quiet);
  CHECK(bench.spm().programmer().lost() == 0);
  type(bench, std::string(40, '?'), quiet);
  CHECK(bench.spm().programmer().lost() == 184 + 40 - 191);  // 127 echoed, 64 unread
  CHECK(bench.has_event(EventCode::hhp_data_lost));
  CHECK(bench.spm().events().total() == before + 1);
  const std::size_t first = bench.turns().size();
  bench.cycle(ready, 30);
  CHECK(shown_since(bench, first) == long_text(184) + "???????");
  type(bench, long_text(224), quiet);
  CHECK(bench.spm().programmer().lost() == 33 + 33);
  CHECK(bench.spm().events().total() == before + 2);
}

TEST_CASE("characters are said once, whatever happens to the turns", "[SB-03.1][SB-2.9][SB-2.12]") {
  Bench bench = Bench::ready();
  type(bench, long_text(64), quiet);
  const std::size_t first = bench.turns().size();
  SECTION("two generals in one turn") {
    bench.cycle(ready + ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("two generals in one turn, the second without room") {
    bench.cycle(ready + quiet, 5);
    CHECK(shown_since(bench, first).empty());
    bench.cycle(ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("no TF, so that the answer comes after 3 ms") {
    for (int i = 0; i < 20; ++i) {
      bench.hear(ready);
      bench.run_ms(17);
    }
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("wake before the answer was said") {
    bench.hear(ready);
    bench.in.wake = true;
    bench.run_ms(1);
    bench.in.wake = false;
    bench.run_ms(16);
    CHECK(shown_since(bench, first).empty());
    bench.cycle(ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("wake before the answer was said, then a turn that earns none") {
    bench.hear(ready);
    bench.in.wake = true;
    bench.run_ms(1);
    bench.in.wake = false;
    bench.cycle(wire::unknown_type);
    bench.cycle(ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("a corrupt packet in the turn") {
    bench.cycle(ready + corrupted(typed("x")), 2);
    bench.cycle(ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
  SECTION("an echo that differed: what that turn held is gone") {
    bench.hear(ready + wire::tf);
    bench.clash();
    bench.run_ms(17);
    bench.cycle(ready, 20);
    CHECK(shown_since(bench, first) == long_text(64));
  }
}

TEST_CASE("nobody's HHP data is taken before the first general, nor kept over a new power-up", "[SB-02.1][SB-3.4]") {
  Bench bench = Bench::greeted();
  bench.cycle(wire::sr_power_up + typed("early"));
  bench.cycle(ready, 5);
  CHECK(shown_since(bench, 0).empty());
  type(bench, long_text(64), quiet);
  bench.cycle(wire::sr_power_up);
  CHECK(bench.last_turn() == Bytes{0x05, 0x80, 0xFA, 0x0F});
  bench.cycle(ready, 20);
  CHECK(shown_since(bench, 0).empty());
  type(bench, "again", ready);
  bench.cycle(ready, 2);
  CHECK(shown_since(bench, 0) == "again");
}

TEST_CASE("HHP traffic both ways leaves driving alone", "[SB-2.2]") {
  Bench bench = Bench::ready();
  const Bytes forward{0x60, 0xFF, 0xC0, 0xFF, 0xF2, 0x80, 0x84, 0x80, 0xEB};
  const std::string text = long_text(8 * 400);
  type(bench, text, forward);
  CHECK(bench.left() == 16384);
  CHECK_FALSE(bench.is_limping());
  bench.cycle(forward, 2);
  CHECK(shown_since(bench, 0) == text);
}

}  // namespace
