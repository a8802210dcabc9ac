// Everything between a driver's stick and the wheels: command, brakes, ramps, and the gate at the end.
#pragma once

#include <stdint.h>

#include "drivers/base/time.hpp"
#include "spm/current_limit.hpp"
#include "spm/drive.hpp"
#include "spm/drive_gate.hpp"
#include "spm/park_brake.hpp"
#include "spm/settings.hpp"

namespace spm {

class Motion {
 public:
  // What the rest of the power module thinks of driving right now.
  struct Leave {
    bool may_drive = false;  // no inhibit of any kind
    bool is_limping = true;
    base::Millis general_age = base::Millis(UINT32_MAX);
    bool must_cut = false;      // an output is stuck: no ramp, brakes at once (H-10)
    bool may_release = false;   // the bridges have shown that they block (H-10)
    bool are_coils_on = false;  // both brakes' coils were seen to be on (H-13)
  };

  // After a start and whenever settings change; the chair must be at rest.
  void configure(const Settings& settings);

  // A general's stick; counts from the next step on.
  void command(const Stick& stick) {
    stick_ = stick;
    is_command_stale_ = true;
  }

  // Each `limits::house_keeping`: what the motors draw (H-31), and what the battery can give and take (H-26). No
  // command asks for more than `most`, from the next general on; less than full demand halves the acceleration as well.
  void watch(const Inputs& in);
  void spare_battery(Demand most, bool is_over_voltage);

  // One millisecond.
  void step(const Leave& leave, base::Instant now);

  Wheels demand() const { return granted_; }
  bool is_stick_at_rest() const { return is_at_rest(stick_, profile_); }
  // Ready for torque: the bus calls it driving (SB-01.4).
  bool is_driving() const { return park_brake_.allows_torque(); }
  bool are_brakes_released() const { return park_brake_.is_released(); }
  // As of the last general, or 0 as soon as the wheels get nothing (SB-01.7).
  uint8_t speedo() const { return speedo_; }
  // H-31: until it is over, and the stick has been seen at rest.
  bool is_stalled() const { return current_limit_.is_stalled(); }
  // The gate was once handed nonsense.
  bool has_refused() const { return gate_.has_refused(); }
  // Something that commands motion has changed in memory by itself; it has been mended (H-27).
  bool has_mended() const { return has_mended_ || park_brake_.has_mended(); }
  // Whether what configure() made of the settings still is what it was (H-27).
  bool is_configuration_intact() const { return sum_of_configuration() == configuration_sum_; }

 private:
  void mend();
  uint16_t sum_of_configuration() const;

  DriveProfile profile_ = {};
  struct Rates {
    uint16_t acceleration;
    uint16_t forward_deceleration;
    uint16_t reverse_deceleration;
  };
  Rates own_ = {};  // as the settings have them, whatever the battery allows
  Demand most_ = full_demand;
  bool is_battery_low_ = false;
  bool is_over_voltage_ = false;
  ParkBrake::Times brake_times_ = {};
  uint16_t configuration_sum_ = 0;
  Stick stick_;
  Command command_;
  bool is_command_stale_ = true;
  bool was_limping_ = false;
  Ramps ramps_;
  ParkBrake park_brake_;
  CurrentLimit current_limit_;
  DriveGate gate_;
  Wheels granted_;  // as the gate and the ramps remember it, too
  bool has_mended_ = false;
  uint8_t speedo_ = 0;
};

}  // namespace spm
