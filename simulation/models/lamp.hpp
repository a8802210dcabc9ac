// A lamp at a switched 24 V output, with the current that its sensor shows. Its inrush is left out.
#pragma once

namespace simulation {

enum class LampPlace { left_indicator, right_indicator, headlight };

// Anything of it may be there at once; of a wire that is off, the rest does not show.
enum class LampDamage { open, shorted };

class Lamp {
 public:
  static constexpr double shorted_current = 8;  // A: what fuse and wires let pass

  // `nominal`: A, while it is lit.
  explicit Lamp(double nominal) : nominal_(nominal) {}

  void set_damage(LampDamage damage, bool is_there) {
    (damage == LampDamage::open ? is_open_ : is_shorted_) = is_there;
  }
  double current(bool is_on) const {  // A
    return !is_on || is_open_ ? 0 : is_shorted_ ? shorted_current : nominal_;
  }

 private:
  double nominal_;
  bool is_open_ = false;
  bool is_shorted_ = false;
};

}  // namespace simulation
