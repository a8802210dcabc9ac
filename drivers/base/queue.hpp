// Items in the order they came, for one side alone; between an interrupt and the loop there is Ring. `N` is a power of
// two, at most 128, and all of them can be used.
#pragma once

#include <stdint.h>

namespace base {

template <typename T, uint8_t N>
class Queue {
  static_assert(N >= 2 && N <= 128 && (N & (N - 1)) == 0, "a queue holds a power of two of items, at most 128");

 public:
  constexpr Queue() : items_(), first_(0), size_(0) {}

  // False (and nothing stored) when the queue is full.
  bool put(const T& item) {
    if (size_ == N) {
      return false;
    }
    items_[place(size_)] = item;
    ++size_;
    return true;
  }

  // False (and `item` untouched) when the queue is empty.
  bool take(T& item) {
    if (size_ == 0) {
      return false;
    }
    item = items_[first_];
    drop(1);
    return true;
  }

  // The oldest item is 0; index < size().
  const T& operator[](uint8_t index) const { return items_[place(index)]; }

  // Forgets the oldest `count`, at most size() of them.
  void drop(uint8_t count) {
    first_ = place(count);
    size_ = static_cast<uint8_t>(size_ - count);
  }
  void clear() { size_ = 0; }

  bool empty() const { return size_ == 0; }
  uint8_t size() const { return size_; }
  uint8_t room() const { return static_cast<uint8_t>(N - size_); }

 private:
  uint8_t place(uint8_t index) const { return static_cast<uint8_t>((first_ + index) & (N - 1U)); }

  T items_[N];
  uint8_t first_;
  uint8_t size_;
};

}  // namespace base
