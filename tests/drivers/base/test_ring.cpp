#include "drivers/base/ring.hpp"

#include <catch2/catch.hpp>
#include <thread>

namespace {

TEST_CASE("a ring gives back what was put in, oldest first") {
  base::Ring<int, 4> ring;
  CHECK(ring.empty());
  CHECK(ring.put(1));
  CHECK(ring.put(2));
  CHECK_FALSE(ring.empty());
  int item = 0;
  CHECK(ring.take(item));
  CHECK(item == 1);
  CHECK(ring.take(item));
  CHECK(item == 2);
  CHECK(ring.empty());
}

TEST_CASE("a full ring refuses and keeps what it has") {
  base::Ring<int, 4> ring;
  CHECK(ring.put(1));
  CHECK(ring.put(2));
  CHECK(ring.put(3));
  CHECK_FALSE(ring.put(4));  // one place stays free
  int item = 0;
  for (int expected = 1; expected <= 3; ++expected) {
    REQUIRE(ring.take(item));
    CHECK(item == expected);
  }
  CHECK_FALSE(ring.take(item));
}

TEST_CASE("taking from an empty ring leaves the item alone") {
  base::Ring<int, 2> ring;
  int item = 77;
  CHECK_FALSE(ring.take(item));
  CHECK(item == 77);
}

TEST_CASE("a ring of the largest size works on across every place of its indices") {
  base::Ring<std::uint16_t, 128> ring;
  std::uint16_t next_in = 0;
  std::uint16_t next_out = 0;
  for (int round = 0; round < 300; ++round) {
    while (ring.put(next_in)) {
      ++next_in;
    }
    CHECK(next_in - next_out == 127);
    std::uint16_t item = 0;
    for (int i = 0; i < 100; ++i) {
      REQUIRE(ring.take(item));
      REQUIRE(item == next_out++);
    }
  }
}

TEST_CASE("clearing drops everything and leaves room for a full load") {
  base::Ring<int, 4> ring;
  ring.put(1);
  ring.put(2);
  ring.clear();
  CHECK(ring.empty());
  CHECK(ring.put(3));
  CHECK(ring.put(4));
  CHECK(ring.put(5));
  int item = 0;
  CHECK(ring.take(item));
  CHECK(item == 3);
}

TEST_CASE("nothing is lost, doubled or reordered between a producer and a consumer that run at the same time") {
  base::Ring<std::uint32_t, 16> ring;
  constexpr std::uint32_t count = 100000;
  std::thread producer([&ring] {
    for (std::uint32_t i = 0; i < count;) {
      if (ring.put(i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::uint32_t wrong = 0;
  for (std::uint32_t expected = 0; expected < count;) {
    std::uint32_t item = 0;
    if (ring.take(item)) {
      wrong += item != expected ? 1U : 0U;
      ++expected;
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
  CHECK(wrong == 0);
  CHECK(ring.empty());
}

}  // namespace
