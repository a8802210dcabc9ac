#include "bus/shark/packet_table.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace bus::shark;

TEST_CASE("the packet table says of every type what the document says", "[SB-5.1][SB-5.3][SB-2.2]") {
  struct Said {
    Sender sender;
    int least_heard;
    int most_said;
  };
  const Said document[16] = {
      {Sender::remote, 6, 0},        // 00 SR general
      {Sender::power_module, 0, 7},  // 01 SPM general
      {Sender::remote, 1, 0},        // 02 SR HHP data
      {Sender::power_module, 0, 8},  // 03 SPM HHP data
      {Sender::remote, 6, 0},        // 04 SR power-up
      {Sender::power_module, 0, 1},  // 05 SPM power-up
      {Sender::remote_or_attendant, 1, 0},
      {Sender::tester, 3, 0},        // 07 factory test
      {Sender::attendant, 6, 0},     // 08 SACU general
      {Sender::attendant, 7, 0},     // 09 SACU power-up
      {Sender::power_module, 0, 2},  // 0A settings
      {Sender::nobody, 0, 0},
      {Sender::nobody, 0, 0},
      {Sender::nobody, 0, 0},
      {Sender::nobody, 0, 0},
      {Sender::nobody, 0, 0},
  };
  for (unsigned type = 0; type < 16; ++type) {
    const PacketRow row = base::from_flash(packet_table[type]);
    CAPTURE(type);
    CHECK(row.type == type);
    CHECK(row.sender == document[type].sender);
    CHECK(row.least_heard == document[type].least_heard);
    CHECK(row.most_said == document[type].most_said);
  }
  CHECK(bytes_said(Type::spm_general) == 9);
  CHECK(bytes_said(Type::spm_hhp_data) == 10);
  CHECK(bytes_said(Type::spm_settings) == 4);
  CHECK(bytes_said(Type::spm_power_up) == 3);
}

}  // namespace
