// What one group of vectors came to: a digest of all its results in order, their number, and a few single results
// that were worked out by hand. The same on every machine, or the product computes differently there.
#pragma once

#include <stdint.h>

namespace vectors {

class Record {
 public:
  static constexpr uint8_t most_known = 20;

  // Any result as a number, negative ones in two's complement. FNV-1a by words; without the last line a difference
  // in high bits would never reach the low ones.
  void add(uint32_t result) {
    digest_ = (digest_ ^ result) * 16777619U;
    digest_ ^= digest_ >> 16;
    ++count_;
  }

  // A result whose value is known without running the code. Compared on the host only, for both machines.
  void known(int32_t actual, int32_t expected) {
    add(static_cast<uint32_t>(actual));
    if (known_count_ < most_known) {
      actual_[known_count_] = actual;
      expected_[known_count_] = expected;
    }
    ++known_count_;
  }

  uint32_t digest() const { return digest_; }
  uint32_t count() const { return count_; }
  uint8_t known_count() const { return known_count_; }
  int32_t actual(uint8_t which) const { return actual_[which]; }
  int32_t expected(uint8_t which) const { return expected_[which]; }

 private:
  uint32_t digest_ = 2166136261U;
  uint32_t count_ = 0;
  uint8_t known_count_ = 0;
  int32_t actual_[most_known] = {};
  int32_t expected_[most_known] = {};
};

}  // namespace vectors
