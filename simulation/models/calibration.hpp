// How far a joystick has been led round since its calibration began: data byte 0 of the calibration packet (SB-06.1).
// Remote and attendant control have one each.
#pragma once

#include <cstdlib>

namespace simulation {

class Calibration {
 public:
  // The stick's readings, 0 to 1023, once a turn.
  void watch(int speed, int direction) {
    note(forward, speed - middle >= far);
    note(reverse, middle - speed >= far);
    note(left, middle - direction >= far);
    note(right, direction - middle >= far);
    const bool is_neutral = std::abs(speed - middle) <= near && std::abs(direction - middle) <= near;
    note(neutral, (seen_ & all_round) == all_round && is_neutral);
  }
  void begin_anew() { seen_ = 0; }

  int data(bool is_second_pass) const { return seen_ | (is_second_pass ? second_pass : 0); }

 private:
  enum Bit { right = 0x01, left = 0x02, reverse = 0x04, forward = 0x08, neutral = 0x10, second_pass = 0x20 };
  static constexpr int all_round = right | left | reverse | forward;
  static constexpr int middle = 512;
  static constexpr int far = 400;
  static constexpr int near = 30;

  void note(Bit bit, bool is_seen) { seen_ |= is_seen ? bit : 0; }

  int seen_ = 0;
};

}  // namespace simulation
