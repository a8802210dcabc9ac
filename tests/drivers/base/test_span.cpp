#include "drivers/base/span.hpp"

#include <catch2/catch.hpp>
#include <numeric>

namespace {

TEST_CASE("an array knows its size and can be walked") {
  base::Array<std::uint8_t, 3> array = {{1, 2, 3}};
  CHECK(array.size() == 3);
  array[1] = 7;
  CHECK(std::accumulate(array.begin(), array.end(), 0) == 11);
  const base::Array<std::uint8_t, 3>& same = array;
  CHECK(same[1] == 7);
  CHECK(same.end() - same.begin() == 3);
}

TEST_CASE("a span sees its owner's items, and a default one sees none") {
  std::uint8_t items[4] = {1, 2, 3, 4};
  const base::Span<std::uint8_t> span(items, 3);
  CHECK(span.size() == 3);
  CHECK_FALSE(span.empty());
  span[2] = 9;
  CHECK(items[2] == 9);
  CHECK(std::accumulate(span.begin(), span.end(), 0) == 12);
  CHECK(base::Span<std::uint8_t>().empty());
  CHECK(base::Span<std::uint8_t>().begin() == base::Span<std::uint8_t>().end());
}

TEST_CASE("an optional tells absence from zero") {
  base::Optional<int> value;
  CHECK_FALSE(value.has_value());
  value = 0;
  CHECK(value.has_value());
  CHECK(static_cast<bool>(value));
  CHECK(*value == 0);
  value.reset();
  CHECK_FALSE(value.has_value());
}

}  // namespace
