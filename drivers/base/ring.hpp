// Single-producer single-consumer ring. One side (an interrupt) calls put(), the other (the loop)
// calls take(). Indices are one byte, so each is read and written in one instruction on an AVR;
// no lock is needed. `N` is a power of two, at most 128; one place stays free.
//
// Invariants: head_ is written by the producer only, tail_ by the consumer only; an item is stored
// before head_ moves past it.
#pragma once

#include <stdint.h>

namespace base {

template <typename T, uint8_t N>
class Ring {
  static_assert(N >= 2 && N <= 128 && (N & (N - 1)) == 0, "a ring holds a power of two of items, at most 128");

 public:
  constexpr Ring() : items_(), head_(0), tail_(0) {}

  // False (and nothing stored) when the ring is full.
  bool put(const T& item) {
    const uint8_t head = load(head_);
    const uint8_t next = static_cast<uint8_t>((head + 1U) & (N - 1U));
    if (next == load(tail_)) {
      return false;
    }
    items_[head] = item;
    barrier();
    store(head_, next);
    return true;
  }

  // False (and `item` untouched) when the ring is empty.
  bool take(T& item) {
    const uint8_t tail = load(tail_);
    if (tail == load(head_)) {
      return false;
    }
    barrier();
    item = items_[tail];
    barrier();
    store(tail_, static_cast<uint8_t>((tail + 1U) & (N - 1U)));
    return true;
  }

  bool empty() const { return load(head_) == load(tail_); }
  // For the consumer only: drops everything there is.
  void clear() { store(tail_, load(head_)); }

 private:
  // The compiler must neither cache an index nor move an item's copy across its index.
  static uint8_t load(const uint8_t& index) { return __atomic_load_n(&index, __ATOMIC_RELAXED); }
  static void store(uint8_t& index, uint8_t value) { __atomic_store_n(&index, value, __ATOMIC_RELAXED); }
  static void barrier() { __asm__ __volatile__("" ::: "memory"); }

  T items_[N];
  uint8_t head_;
  uint8_t tail_;
};

}  // namespace base
