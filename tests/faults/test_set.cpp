#include "faults/set.hpp"

#include <catch2/catch.hpp>

namespace {

enum class Fruit : std::uint8_t { apple, pear, plum, last = 15 };
using Basket = faults::Set<Fruit>;

TEST_CASE("a set holds what was put in and lets go of what was taken out") {
  Basket basket;
  CHECK(basket.empty());
  basket.add(Fruit::pear);
  basket.put(Fruit::last, true);
  CHECK(basket.has(Fruit::pear));
  CHECK(basket.has(Fruit::last));
  CHECK_FALSE(basket.has(Fruit::apple));
  basket.put(Fruit::pear, false);
  CHECK_FALSE(basket.has(Fruit::pear));
  CHECK(basket == Basket::of(Fruit::last));
  CHECK(basket.bits() == 0x8000);
}

TEST_CASE("sets are joined, cut and compared") {
  const Basket both = Basket::of(Fruit::apple) | Basket::of(Fruit::plum);
  CHECK(both.has(Basket::of(Fruit::plum)));
  CHECK((both & Basket::of(Fruit::plum)) == Basket::of(Fruit::plum));
  CHECK(both.without(Basket::of(Fruit::plum)) == Basket::of(Fruit::apple));
  CHECK(both.without(Basket::of(Fruit::pear)) == both);
  CHECK(both != Basket::of(Fruit::apple));
  CHECK_FALSE(both.has(Basket::of(Fruit::pear)));
}

TEST_CASE("walking a set meets every item once") {
  Basket walker = Basket::first();
  for (int i = 0; i < 16; ++i) {
    CHECK(walker == Basket::of(static_cast<Fruit>(i)));
    walker = walker.next();
  }
  CHECK(walker.empty());
}

}  // namespace
