// Keeps both motors from what they cannot stand (H-31): more than their peak current at any time, more than their
// continuous current for long, a stall that nobody ends.
//
//   |I| > peak                     the demand shrinks at once, at every look
//   the winding is half-way hot    the limit sinks with what the winding has taken, from the peak to the continuous one
//   still hotter, and it stands    stalled: the chair stops; neutral before the next try
//
// Goals: a hard stall is over before it looks like a stuck output (H-10: 80 A in four looks); a motor that climbs is
// slowed, not stopped; a chair that its driver has freed from a wall drives off it at once.
// Assumptions: no reading is seen twice; a look sees the current that the limit of the look before has led to.
// Invariants: a demand is only ever made smaller, and it keeps its sign; what comes later (gate, ramps) is told, so
// that nothing is made up for (H-33). A motor that brakes is left alone: to ask for less would make it brake harder.
//
// Where there is time, both wheels are made smaller in proportion: a chair that runs out of current keeps its curve.
// Above the peak there is none: that wheel alone is cut, since a wheel that turns freely must not be braked by what the
// other one has met; the ramps bring the curve back.
#pragma once

#include <stdint.h>

#include "spm/drive.hpp"
#include "spm/inputs.hpp"

namespace spm {

// What a motor's winding has taken: its heat by current squared, less what it gives off. Held at its continuous current
// it ends at a temperature that the limit calls hot, and not beyond.
class Winding {
 public:
  // Each 40 ms; in steps of 256 mA, all beyond 65 A alike.
  void take(uint8_t current) {
    // A 2^12th of it goes each time: a time constant of 164 s.
    heat_ = heat_ + static_cast<uint16_t>(current * uint16_t{current}) - static_cast<uint16_t>(temperature() * 16);
    if (heat_ > most_heat) {  // H-27: no current gets it there
      heat_ = most_heat;
    }
  }
  // Above that of its surroundings; a sixteenth of the current's square in the end.
  uint16_t temperature() const { return static_cast<uint16_t>(heat_ >> 16); }

 private:
  static constexpr uint32_t most_heat = uint32_t{65025 / 16} << 16;

  uint32_t heat_ = 0;
};

class CurrentLimit {
 public:
  // Each `limits::house_keeping`. `given` is what the wheels have, `wanted` what they are to have in the end;
  // `is_at_rest`: stick at rest and brakes engaged, the end of a stall.
  void look(const Inputs& in, const Wheels& given, const Wheels& wanted, bool is_at_rest);

  // Whether bound() has anything to do.
  bool is_acting() const { return is_acting_; }
  Wheels bound(const Wheels& asked) const;
  // A motor stood for too long with all the current it may have, or is far too hot.
  bool is_stalled() const { return is_stalled_; }

 private:
  struct Motor {
    Winding winding;
    uint8_t standing = 0;  // looks that found it so, less those that did not
    int16_t most = full_demand.count();
    bool is_urgent = false;
  };

  static void look_at(Motor& motor, base::Milliamps current, Demand given, Demand wanted, bool is_taken);
  void keep_curve(const Wheels& given);

  Motor left_;
  Motor right_;
  uint8_t turn_ = 0;  // whose winding takes its current at this look
  bool is_acting_ = false;
  bool is_stalled_ = false;
};

}  // namespace spm
