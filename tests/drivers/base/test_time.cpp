#include "drivers/base/time.hpp"

#include <catch2/catch.hpp>
#include <type_traits>

namespace {

using namespace base;

template <typename A, typename B, typename = void>
constexpr bool can_be_added = false;
template <typename A, typename B>
constexpr bool can_be_added<A, B, std::void_t<decltype(std::declval<A>() + std::declval<B>())>> = true;
template <typename A, typename B, typename = void>
constexpr bool can_be_ordered = false;
template <typename A, typename B>
constexpr bool can_be_ordered<A, B, std::void_t<decltype(std::declval<A>() < std::declval<B>())>> = true;

TEST_CASE("a span between two instants is right across the wrap of the clock") {
  CHECK(Instant(5) - Instant(0xFFFFFFFB) == 10_ms);
  CHECK(Instant(0xFFFFFFFB) + 10_ms == Instant(5));
  CHECK(Stamp(0x0010) - Stamp(0xFFF0) == 32_us);
  CHECK(Stamp(0xFFF0) + 32_us == Stamp(0x0010));
  CHECK(Stamp(1) - Stamp(2) == Micros(65535));
}

TEST_CASE("the literals mean what they say") {
  CHECK((60_ms).count() == 60);
  CHECK(5_s == 5000_ms);
  CHECK((3000_us).count() == 3000);
  CHECK((Instant(100) - Instant(40) >= 60_ms));
  CHECK_FALSE((Instant(99) - Instant(40) >= 60_ms));
}

TEST_CASE("what makes no sense does not compile: points added, points ordered, scales and bare numbers mixed") {
  STATIC_REQUIRE_FALSE(can_be_added<Instant, Instant>);
  STATIC_REQUIRE_FALSE(can_be_ordered<Instant, Instant>);
  STATIC_REQUIRE_FALSE(can_be_ordered<Stamp, Stamp>);
  STATIC_REQUIRE_FALSE(can_be_added<Instant, Micros>);
  STATIC_REQUIRE_FALSE(can_be_ordered<Millis, Micros>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<int, Millis>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<Millis, std::uint32_t>);
  STATIC_REQUIRE(can_be_added<Instant, Millis>);
  STATIC_REQUIRE(can_be_ordered<Millis, Millis>);
}

}  // namespace
