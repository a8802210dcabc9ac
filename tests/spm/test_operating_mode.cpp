#include "spm/operating_mode.hpp"

#include <catch2/catch.hpp>

namespace {

using spm::OperatingMode;

TEST_CASE("drive mode is established from the start", "[SB-00.7]") {
  const OperatingMode mode;
  CHECK(mode.mode() == 0);
  CHECK(mode.is_drive());
  CHECK_FALSE(mode.is_invalid());
  CHECK_FALSE(mode.has_changed());
}

TEST_CASE("every mode is echoed at once, refused with the flag", "[SB-00.7][H-17]") {
  for (std::uint8_t requested = 1; requested < 16; ++requested) {
    OperatingMode mode;
    mode.request(requested, false);
    CHECK(mode.mode() == requested);
    CHECK(mode.is_invalid());
    CHECK_FALSE(mode.is_drive());
    CHECK(mode.has_changed());
  }
}

TEST_CASE("drive mode is never invalid", "[SB-00.7]") {
  OperatingMode mode;
  mode.request(1, false);
  mode.request(0, false);
  CHECK(mode.is_drive());
  CHECK_FALSE(mode.is_invalid());
}

TEST_CASE("a mode once sent without the flag keeps free of it until the request changes", "[SB-00.7][H-17]") {
  OperatingMode mode;
  mode.request(1, true);
  CHECK_FALSE(mode.is_invalid());
  mode.request(1, false);
  CHECK_FALSE(mode.is_invalid());
  CHECK(mode.mode() == 1);
  mode.request(2, false);
  CHECK(mode.is_invalid());
  mode.request(1, false);
  CHECK(mode.is_invalid());
}

TEST_CASE("a refused mode may be established later, while the request stands", "[SB-00.7]") {
  OperatingMode mode;
  mode.request(1, false);
  mode.request(1, true);
  CHECK_FALSE(mode.is_invalid());
  mode.request(1, false);
  CHECK_FALSE(mode.is_invalid());
}

TEST_CASE("only another request is a change", "[SB-00.7]") {
  OperatingMode mode;
  mode.request(0, true);
  CHECK_FALSE(mode.has_changed());
  mode.request(1, true);
  CHECK(mode.has_changed());
  mode.request(1, true);
  CHECK_FALSE(mode.has_changed());
  mode.request(0, true);
  CHECK(mode.has_changed());
}

}  // namespace
