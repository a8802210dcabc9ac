#include "bus/shark/turn.hpp"

#include <catch2/catch.hpp>

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

TEST_CASE("a turn holds a general and a full packet of HHP data, and no byte more", "[SB-2.2]") {
  const std::uint8_t text[8] = {'m', 'e', 'n', 'u', '>', ' ', '1', '\r'};
  const Packet hhp(Type::spm_hhp_data, base::Span<const std::uint8_t>(text, 8));
  Turn turn;
  turn.open();
  CHECK(turn.add(encode(SpmGeneral())));
  CHECK(turn.add(hhp));
  CHECK_FALSE(turn.add(encode(SpmPowerUp())));
  turn.close();
  CHECK(turn.bytes().size() == 20);
  CHECK(turn.bytes()[19] == 0x0F);

  turn.open();
  CHECK(turn.add(hhp));
  CHECK_FALSE(turn.add(hhp));  // there would be no room for TF
  turn.close();
  CHECK(turn.bytes().size() == 11);
  CHECK(turn.bytes()[10] == 0x0F);
}

}  // namespace
