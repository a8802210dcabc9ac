#include "bus/shark/frame.hpp"

#include <catch2/catch.hpp>

#include "tests/support/wire_words.hpp"

namespace {

using namespace bus::shark;
using support::Bytes;

TEST_CASE("the tests' own arithmetic makes the packets that real chairs send") {
  CHECK(support::sealed({0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80}).back() == 0xC8);
  CHECK(support::sealed({0x61, 0xB0, 0x89, 0xC0, 0xA0, 0x80, 0x80, 0x87}).back() == 0xFE);
  CHECK(support::sealed({0x05, 0xA3}).back() == 0xD7);
  CHECK(support::sr_general({.speed = 1022, .direction = 514, .byte5 = 0x04}) == support::wire::forward_slow);
  CHECK(support::sr_general({.speed = 7, .direction = 519, .byte5 = 0x04}) == support::wire::reverse_slow);
  CHECK(support::sr_general({.speed = 513, .direction = 509, .pot = 255, .byte5 = 0x0C}) ==
        Bytes{0x60, 0xC0, 0xBF, 0xFF, 0xCD, 0x80, 0x8C, 0x80, 0xC8});
  for (const Bytes& literal :
       {support::wire::at_rest, support::wire::forward_fast, support::wire::reverse_fast, support::wire::joystick_error,
        support::wire::pot_error, support::wire::local_fault, support::wire::charger_inhibit,
        support::wire::button_down, support::wire::remote_inhibit, support::wire::calibrating, support::wire::confirm,
        support::wire::non_critical_fault, support::wire::unknown_type, support::wire::sr_power_up}) {
    CHECK(support::sealed(Bytes(literal.begin(), literal.end() - 1)) == literal);
  }
}

TEST_CASE("a start byte holds the type in bits 3-0 and the length less one in bits 6-4", "[SB-2.3]") {
  CHECK(type_of(0x60) == 0x0);
  CHECK(length_of(0x60) == 7);
  CHECK(type_of(0x74) == 0x4);
  CHECK(length_of(0x74) == 8);
  CHECK(type_of(0x05) == 0x5);
  CHECK(length_of(0x05) == 1);
  CHECK(type_of(0x1A) == 0xA);
  CHECK(length_of(0x1A) == 2);
  CHECK(start_byte(Type::spm_general, 7) == 0x61);
  CHECK(start_byte(Type::spm_power_up, 1) == 0x05);
  CHECK(start_byte(Type::spm_settings, 2) == 0x1A);
  CHECK(start_byte(Type::spm_hhp_data, 8) == 0x73);
}

TEST_CASE("only start bytes and TF have bit 7 clear", "[SB-2.4][SB-2.6]") {
  CHECK(transmit_finished == 0x0F);
  CHECK_FALSE(has_marker(0x0F));
  CHECK_FALSE(has_marker(0x7F));
  CHECK(has_marker(0x80));
  CHECK(has_marker(0xFF));
}

TEST_CASE("the checksum is 0x7F less the low 7 bits of the sum, with bit 7 set", "[SB-2.5]") {
  CHECK(checksum(0x00) == 0xFF);
  CHECK(checksum(0x7F) == 0x80);
  CHECK(checksum(0x80) == 0xFF);
  CHECK(checksum(0x05 + 0x80) == 0xFA);
  CHECK(checksum(static_cast<std::uint8_t>(0x1A + 0xA5 + 0xA7)) == 0x99);
  for (unsigned sum = 0; sum < 256; ++sum) {
    REQUIRE(checksum(static_cast<std::uint8_t>(sum)) == 255 - sum % 128);
  }
}

}  // namespace
