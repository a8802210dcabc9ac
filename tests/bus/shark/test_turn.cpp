#include "bus/shark/turn.hpp"

#include <catch2/catch.hpp>

#include "bus/shark/codec.hpp"
#include "tests/support/wire_words.hpp"

namespace {

using namespace bus::shark;
using support::Bytes;

Bytes bytes_of(const Turn& turn) {
  return Bytes(turn.bytes().begin(), turn.bytes().end());
}

TEST_CASE("a turn is its packets in order, closed by TF", "[SB-2.7][SB-2.6]") {
  Turn turn;
  turn.open();
  CHECK(turn.add(encode(SpmGeneral())));
  CHECK(turn.add(encode(SpmSettings{true, false, 5, 39})));
  turn.close();
  CHECK(bytes_of(turn) == Bytes{0x61, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x9E, 0x1A, 0xA5, 0xA7, 0x99, 0x0F});
}

TEST_CASE("a packet of any data gets its start byte, its markers and its checksum", "[SB-2.3][SB-2.4][SB-2.5]") {
  for (std::uint8_t type = 0; type < 16; ++type) {
    for (std::uint8_t length = 1; length <= 8; ++length) {
      const Frame frame{type, length, {{0x00, 0x7F, 0x10, 0x20, 0x30, 0x40, 0x50, 0x60}}};
      Bytes expected{static_cast<std::uint8_t>(16 * (length - 1) + type)};
      for (std::uint8_t i = 0; i < length; ++i) {
        expected.push_back(static_cast<std::uint8_t>(frame.data[i] + 128));
      }
      Turn turn;
      turn.open();
      CHECK(turn.add(frame));
      CHECK(bytes_of(turn) == support::sealed(expected));
    }
  }
}

TEST_CASE("opening a turn forgets the last one") {
  Turn turn;
  turn.open();
  turn.add(encode(SpmGeneral()));
  turn.close();
  turn.open();
  turn.add(encode(SpmPowerUp()));
  turn.close();
  CHECK(bytes_of(turn) == Bytes{0x05, 0x80, 0xFA, 0x0F});
}

TEST_CASE("a turn holds a general, a full packet of HHP data and settings, 24 bytes with TF, and no byte more",
          "[SB-2.2]") {
  const Frame hhp = encode(HhpData{{{'m', 'e', 'n', 'u', '>', ' ', '1', '\r'}}, 8});
  Turn turn;
  turn.open();
  CHECK(turn.add(encode(SpmGeneral())));
  CHECK(turn.add(hhp));
  CHECK(turn.add(encode(SpmSettings())));
  CHECK_FALSE(turn.add(encode(SpmPowerUp())));
  turn.close();
  CHECK(turn.bytes().size() == 24);
  CHECK(turn.bytes()[23] == 0x0F);
  CHECK(24 * 286.5 <= 8500);

  turn.open();
  CHECK(turn.add(hhp));
  CHECK(turn.add(hhp));
  CHECK_FALSE(turn.add(encode(SpmSettings())));  // there would be no room for TF
  CHECK(turn.add(encode(SpmPowerUp())));
  turn.close();
  CHECK(turn.bytes().size() == 24);
  CHECK(turn.bytes()[23] == 0x0F);
}

}  // namespace
