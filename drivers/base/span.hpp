// The few lines of <array>, <span> and <optional> that the product needs: avr-gcc 5.4 ships no C++
// library. Lengths are 8 bits wide. Indexing is not checked: callers loop to size().
#pragma once

#include <stdint.h>

namespace base {

template <typename T, uint8_t N>
struct Array {
  T items[N];

  static constexpr uint8_t size() { return N; }
  constexpr T& operator[](uint8_t index) { return items[index]; }
  constexpr const T& operator[](uint8_t index) const { return items[index]; }
  T* begin() { return items; }
  T* end() { return items + N; }
  const T* begin() const { return items; }
  const T* end() const { return items + N; }
};

// A view of somebody else's items; valid only as long as they are.
template <typename T>
class Span {
 public:
  constexpr Span() : data_(nullptr), size_(0) {}
  constexpr Span(T* data, uint8_t size) : data_(data), size_(size) {}

  constexpr uint8_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr T& operator[](uint8_t index) const { return data_[index]; }
  constexpr T* begin() const { return data_; }
  constexpr T* end() const { return data_ + size_; }

 private:
  T* data_;
  uint8_t size_;
};

// A value that may be absent. T needs a default constructor.
template <typename T>
class Optional {
 public:
  constexpr Optional() : value_(), has_value_(false) {}
  constexpr Optional(const T& value) : value_(value), has_value_(true) {}  // NOLINT: meant to convert

  constexpr bool has_value() const { return has_value_; }
  constexpr explicit operator bool() const { return has_value_; }
  constexpr const T& operator*() const { return value_; }
  constexpr const T* operator->() const { return &value_; }
  void reset() { *this = Optional(); }

 private:
  T value_;
  bool has_value_;
};

}  // namespace base
