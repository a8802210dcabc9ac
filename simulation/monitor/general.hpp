// The two packets the monitor must understand, read by its own hand from the document (SB-00.1 to SB-00.3, SB-01.1 to
// SB-01.7).
#pragma once

#include <cstdint>

#include "simulation/monitor/ear.hpp"

namespace simulation::monitor {

struct SrGeneral {
  explicit SrGeneral(const Packet& packet);

  Time end{};
  bool is_doubtful;
  int speed;  // 0 to 1023
  int direction;
  bool joystick_error;
  bool pot_error;
  bool local_fault;
  bool charger_inhibit;
  bool power_switch;
  bool remote_inhibit;
  bool calibration;
  bool confirm;
  bool is_old;  // six data bytes: no mode, no lamps
  bool non_critical_fault;
  int mode;

  bool is_neutral() const;
};

struct SpmGeneral {
  explicit SpmGeneral(const Packet& packet);

  bool slowdown;
  int gauge;
  bool drive_inhibited;
  bool power_down_now;
  int state;
  bool drive_modified;  // of the remote
  bool sleep_requested;
  bool shows_lamps;  // any lamp status or cadence
  bool sacu_drives;
  bool mode_invalid;
  int mode;
  bool has_stray_bits;  // unused ones
};

}  // namespace simulation::monitor
