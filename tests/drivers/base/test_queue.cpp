#include "drivers/base/queue.hpp"

#include <catch2/catch.hpp>
#include <deque>
#include <random>

namespace {

TEST_CASE("a queue gives back what was put in, in the same order") {
  base::Queue<char, 8> queue;
  CHECK(queue.put('a'));
  CHECK(queue.put('b'));
  char item = '?';
  CHECK(queue.take(item));
  CHECK(item == 'a');
  CHECK(queue.put('c'));
  CHECK(queue.take(item));
  CHECK(item == 'b');
  CHECK(queue.take(item));
  CHECK(item == 'c');
  CHECK_FALSE(queue.take(item));
  CHECK(item == 'c');
  CHECK(queue.empty());
}

TEST_CASE("all places of a queue can be used, and no more") {
  base::Queue<char, 4> queue;
  for (const char item : {'1', '2', '3', '4'}) {
    CHECK(queue.put(item));
  }
  CHECK(queue.room() == 0);
  CHECK_FALSE(queue.put('5'));
  CHECK(queue.size() == 4);
  CHECK(queue[0] == '1');
  CHECK(queue[3] == '4');
}

TEST_CASE("clearing a queue forgets everything, dropping only the oldest") {
  base::Queue<char, 4> queue;
  queue.put('1');
  queue.put('2');
  queue.put('3');
  queue.drop(2);
  CHECK(queue.size() == 1);
  CHECK(queue[0] == '3');
  queue.clear();
  CHECK(queue.empty());
  CHECK(queue.room() == 4);
}

TEST_CASE("a queue of 128 agrees with a list whatever is done to it") {
  base::Queue<std::uint8_t, 128> queue;
  std::deque<std::uint8_t> list;
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = static_cast<std::uint8_t>(random());
    const bool is_filling = i / 400 % 2 == 0;
    if (random() % 4 < (is_filling ? 3 : 1)) {
      REQUIRE(queue.put(value) == (list.size() < 128));
      if (list.size() < 128) {
        list.push_back(value);
      }
    } else if (random() % 8 == 0) {
      const auto count = static_cast<std::uint8_t>(random() % (list.size() + 1));
      queue.drop(count);
      list.erase(list.begin(), list.begin() + count);
    } else {
      std::uint8_t item = 0;
      REQUIRE(queue.take(item) == !list.empty());
      if (!list.empty()) {
        REQUIRE(item == list.front());
        list.pop_front();
      }
    }
    REQUIRE(queue.size() == list.size());
    REQUIRE(queue.room() == 128 - list.size());
    if (!list.empty()) {
      const auto place = random() % list.size();
      REQUIRE(queue[static_cast<std::uint8_t>(place)] == list[place]);
    }
  }
}

}  // namespace
