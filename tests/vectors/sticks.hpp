// Every stick position there is, from the reading to the two wheels, as a few digests: the same on the chip and on the
// host, or `int` has overflowed on one of them (H-11). Cheap sums: a million positions are run on the simulated chip.
#pragma once

#include <stdint.h>

#include "spm/drive.hpp"

namespace vectors {

constexpr uint16_t stick_readings = 1024;
constexpr uint8_t stick_blocks = 16;  // of 64 readings of speed each; a difference is found in one of them

class StickDigest {
 public:
  void add(const spm::Wheels& wheels) {
    first_ = static_cast<uint16_t>(turned(first_) + static_cast<uint16_t>(wheels.left.count()));
    second_ = static_cast<uint16_t>(turned(second_) ^ first_);
    second_ = static_cast<uint16_t>(second_ + static_cast<uint16_t>(wheels.right.count()));
    ++count_;
  }
  uint32_t value() const { return (static_cast<uint32_t>(first_) << 16) | second_; }
  uint32_t count() const { return count_; }

 private:
  static uint16_t turned(uint16_t value) { return static_cast<uint16_t>((value << 1) | (value >> 15)); }

  uint16_t first_ = 0;
  uint16_t second_ = 0;
  uint32_t count_ = 0;
};

struct StickOrder {
  bool is_one_pot;     // or each position has its own: all 256 take turns, in LIMP and without
  uint8_t pot;         // that one
  uint8_t speed_step;  // 1: every reading
};

inline spm::Wheels wheels_of(uint16_t speed, uint16_t direction, uint8_t pot, bool is_limping,
                             const spm::DriveProfile& profile) {
  spm::Stick stick;
  stick.speed = bus::shark::JoystickReading(speed);
  stick.direction = bus::shark::JoystickReading(direction);
  stick.pot = bus::shark::PotReading(pot);
  return spm::mix(spm::command_of(stick, profile, is_limping));
}

inline uint8_t own_pot(uint16_t speed, uint16_t direction) {
  return static_cast<uint8_t>(static_cast<uint8_t>(speed) * 37U + static_cast<uint8_t>(direction) * 101U +
                              (direction >> 8));
}

inline StickDigest stick_block(uint8_t block, const StickOrder& order, const spm::DriveProfile& profile) {
  StickDigest digest;
  const uint16_t begin = static_cast<uint16_t>(block * uint16_t{64});
  for (uint16_t speed = begin; speed < begin + 64U; speed = static_cast<uint16_t>(speed + order.speed_step)) {
    for (uint16_t direction = 0; direction < stick_readings; ++direction) {
      if (order.is_one_pot) {
        digest.add(wheels_of(speed, direction, order.pot, false, profile));
        digest.add(wheels_of(speed, direction, order.pot, true, profile));
      } else {
        const bool is_limping = ((speed ^ (direction >> 9)) & 1U) != 0;
        digest.add(wheels_of(speed, direction, own_pot(speed, direction), is_limping, profile));
      }
    }
  }
  return digest;
}

}  // namespace vectors
