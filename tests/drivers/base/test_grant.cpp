#include "drivers/base/grant.hpp"

#include <catch2/catch.hpp>
#include <cstring>

namespace {

using base::Grant;

// With some bits of its byte turned over.
Grant flipped(Grant grant, unsigned bits) {
  unsigned char byte;
  static_assert(sizeof byte == sizeof grant, "a grant is a byte");
  std::memcpy(&byte, &grant, 1);
  byte = static_cast<unsigned char>(byte ^ bits);
  std::memcpy(static_cast<void*>(&grant), &byte, 1);
  return grant;
}

TEST_CASE("a grant is withheld to begin with, given and withheld again") {
  Grant grant;
  CHECK_FALSE(grant.is_given());
  grant.give();
  CHECK(grant.is_given());
  grant.withhold();
  CHECK_FALSE(grant.is_given());
  CHECK(grant.is_intact());
  CHECK(Grant(true).is_given());
}

TEST_CASE("up to seven flipped bits take a grant away, and none of them gives one; all of them are noticed", "[H-27]") {
  for (unsigned bits = 1; bits < 255; ++bits) {
    CAPTURE(bits);
    REQUIRE_FALSE(flipped(Grant(true), bits).is_given());
    REQUIRE_FALSE(flipped(Grant(false), bits).is_given());
    REQUIRE_FALSE(flipped(Grant(true), bits).is_intact());
    REQUIRE_FALSE(flipped(Grant(false), bits).is_intact());
  }
}

}  // namespace
