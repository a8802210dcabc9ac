#include "drivers/base/turn_sender.hpp"

#include <catch2/catch.hpp>

#include "tests/support/wire_words.hpp"

namespace {

using base::TurnSender;
using Heard = base::TurnSender::Heard;
using State = base::TurnSender::State;
using support::Bytes;

const Bytes settings{0x1A, 0xA5, 0xA7, 0x99, 0x0F};
constexpr std::uint8_t tf = 0x0F;

// The sender with the interrupts of a transmitter and a receiver that hear each other.
struct Line {
  TurnSender sender;

  void load(const Bytes& turn) {
    sender.load(base::Span<const std::uint8_t>(turn.data(), static_cast<std::uint8_t>(turn.size())));
  }
  // Sends what there is, each byte heard again as it was; returns what was sent.
  Bytes send(std::size_t most = 100) {
    Bytes sent;
    std::uint8_t byte = 0;
    while (sent.size() < most && sender.next(byte)) {
      sent.push_back(byte);
      CHECK(sender.hear(byte, false) == Heard::echo);
    }
    return sent;
  }
};

TEST_CASE("an idle sender passes on everything it hears and says nothing", "[SB-1.1]") {
  Line line;
  std::uint8_t byte = 0;
  CHECK(line.sender.state() == State::idle);
  CHECK(line.sender.hear(0x60, false) == Heard::data);
  CHECK(line.sender.hear(tf, false) == Heard::data);
  CHECK(line.sender.hear(0x00, true) == Heard::data);
  CHECK_FALSE(line.sender.next(byte));
  CHECK_FALSE(line.sender.has_more());
  CHECK(line.sender.state() == State::idle);
}

TEST_CASE("an armed turn begins with a clean terminator and with nothing else", "[SB-2.7]") {
  Line line;
  line.load(settings);
  line.sender.arm(tf, true);
  std::uint8_t byte = 0;
  CHECK(line.sender.hear(0x60, false) == Heard::data);
  CHECK(line.sender.hear(tf, true) == Heard::data);  // spoiled: not to be trusted
  CHECK_FALSE(line.sender.next(byte));
  CHECK(line.sender.state() == State::armed);

  CHECK(line.sender.hear(tf, false) == Heard::start);
  CHECK(line.sender.state() == State::speaking);
  CHECK(line.send() == settings);
  line.sender.finished();
  CHECK(line.sender.state() == State::idle);
}

TEST_CASE("a turn that is armed just after its terminator begins at once", "[SB-2.7]") {
  Line line;
  line.load(settings);
  line.sender.hear(0x9F, false);
  line.sender.hear(tf, false);
  CHECK(line.sender.arm(tf, true));
  CHECK(line.sender.state() == State::speaking);
  CHECK(line.send() == settings);
}

TEST_CASE("a terminator that was spoiled, or is not the last that was heard, does not begin a turn", "[SB-2.7][H-30]") {
  Line line;
  line.load(settings);
  SECTION("nothing was heard") {}
  SECTION("spoiled") {
    line.sender.hear(tf, true);
  }
  SECTION("something came after it") {
    line.sender.hear(tf, false);
    line.sender.hear(0x60, false);
  }
  CHECK_FALSE(line.sender.arm(tf, true));
  CHECK(line.sender.state() == State::armed);
  CHECK(line.sender.hear(tf, false) == Heard::start);
}

TEST_CASE("a terminator that was heard too long ago does not begin a turn", "[SB-2.8][H-30]") {
  Line line;
  line.load(settings);
  line.sender.hear(tf, false);
  CHECK_FALSE(line.sender.arm(tf, false));
  CHECK(line.sender.state() == State::armed);
}

TEST_CASE("one terminator begins one turn", "[SB-2.7][H-30]") {
  Line line;
  line.load(settings);
  SECTION("armed before it") {
    line.sender.arm(tf, true);
    line.sender.hear(tf, false);
  }
  SECTION("armed after it") {
    line.sender.hear(tf, false);
    line.sender.arm(tf, true);
  }
  CHECK(line.send() == settings);
  line.sender.finished();
  line.load(settings);
  CHECK_FALSE(line.sender.arm(tf, true));
  CHECK(line.sender.state() == State::armed);
}

TEST_CASE("a turn without a terminator is sent on command", "[SB-2.12]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  CHECK(line.send() == settings);
}

TEST_CASE("our own characters never come back as data, and the turn after them does", "[SB-1.4]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  line.send();
  CHECK_FALSE(line.sender.take_clash());
  line.sender.finished();
  CHECK(line.sender.hear(0x1A, false) == Heard::data);
}

TEST_CASE("an echo that differs ends the turn at once and is told once", "[SB-1.4]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  line.send(2);
  std::uint8_t byte = 0;
  REQUIRE(line.sender.next(byte));
  CHECK(byte == 0xA7);

  SECTION("another value") {
    CHECK(line.sender.hear(0xA6, false) == Heard::clash);
  }
  SECTION("the right value with a framing error") {
    CHECK(line.sender.hear(0xA7, true) == Heard::clash);
  }

  CHECK_FALSE(line.sender.next(byte));
  CHECK_FALSE(line.sender.has_more());
  CHECK(line.sender.take_clash());
  CHECK_FALSE(line.sender.take_clash());
  line.sender.finished();
  CHECK(line.sender.state() == State::idle);
}

TEST_CASE("after a clash nothing on the line counts as an echo until the turn is over", "[SB-1.4]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  std::uint8_t byte = 0;
  REQUIRE(line.sender.next(byte));
  CHECK(line.sender.hear(0x00, true) == Heard::clash);
  CHECK(line.sender.hear(0x1A, false) == Heard::clash);
  CHECK_FALSE(line.sender.next(byte));
}

TEST_CASE("somebody else's character while ours are all accounted for is a clash", "[SB-1.4][SB-2.18]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  line.send(3);
  CHECK(line.sender.hear(0x99, false) == Heard::clash);  // the value that is due next, but not sent yet
  CHECK(line.sender.take_clash());
}

TEST_CASE("a character that was on its way when we decided to speak is still data") {
  Line line;
  line.load(settings);
  line.sender.begin();
  CHECK(line.sender.hear(0x42, false) == Heard::data);
  CHECK(line.send() == settings);
}

TEST_CASE("hushing forgets an armed turn", "[SB-1.3]") {
  Line line;
  line.load(settings);
  line.sender.arm(tf, true);
  line.sender.hush();
  CHECK(line.sender.state() == State::idle);
  CHECK(line.sender.hear(tf, false) == Heard::data);
  std::uint8_t byte = 0;
  CHECK_FALSE(line.sender.next(byte));
}

TEST_CASE("hushing cuts a turn short, but the character on the line is still ours", "[SB-1.3]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  line.send(1);
  std::uint8_t byte = 0;
  REQUIRE(line.sender.next(byte));
  line.sender.hush();
  CHECK(line.sender.state() == State::speaking);
  CHECK_FALSE(line.sender.has_more());
  CHECK(line.sender.hear(0xA5, false) == Heard::echo);
  CHECK_FALSE(line.sender.next(byte));
  line.sender.finished();
  CHECK(line.sender.state() == State::idle);
}

TEST_CASE("hushing a turn that was to begin but has not ends it") {
  Line line;
  line.load(settings);
  line.sender.begin();
  line.sender.hush();
  CHECK(line.sender.state() == State::idle);
}

TEST_CASE("a second turn is sent whole after a first one that broke off", "[SB-1.4]") {
  Line line;
  line.load(settings);
  line.sender.begin();
  std::uint8_t byte = 0;
  REQUIRE(line.sender.next(byte));
  line.sender.hear(0x00, false);
  line.sender.finished();
  CHECK(line.sender.take_clash());

  const Bytes power_up{0x05, 0x80, 0xFA, 0x0F};
  line.load(power_up);
  line.sender.arm(tf, true);
  CHECK(line.sender.hear(tf, false) == Heard::start);
  CHECK(line.send() == power_up);
  CHECK_FALSE(line.sender.take_clash());
}

TEST_CASE("a turn longer than the sender holds is cut, never read beyond") {
  Line line;
  line.load(Bytes(40, 0xC3));
  line.sender.begin();
  CHECK(line.send() == Bytes(24, 0xC3));
}

}  // namespace
