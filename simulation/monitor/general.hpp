// The packets the monitor must understand, read by its own hand from the document (SB-00.1 to SB-00.3, SB-01.1 to
// SB-01.7, SB-04.1, SB-05.1, SB-08.1, SB-09.1).
#pragma once

#include <cstdint>

#include "simulation/monitor/ear.hpp"

namespace simulation::monitor {

// Where a stick stands, and what its module wants to be done with it.
struct Joystick {
  Time end{};
  bool is_doubtful = false;
  int speed = 0;  // 0 to 1023
  int direction = 0;
  int mode = 0;

  bool is_neutral() const;
};

struct SrGeneral : Joystick {
  explicit SrGeneral(const Packet& packet);

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
  bool hazard;
  bool left;
  bool right;
  bool headlight;
};

struct SacuGeneral : Joystick {
  explicit SacuGeneral(const Packet& packet);

  bool joystick_error;
  bool pot_error;
  bool local_fault;
  bool calibration;
  bool wants_to_drive;  // the attendant switch
  bool non_critical_fault;
  bool inhibit;
};

// What a module can do, as its power-up packet tells: bits as the document numbers them, the same for all three where
// they mean the same.
struct Capabilities {
  static constexpr int lighting = 1;   // not of an attendant control: there it is speed control
  static constexpr int actuator1 = 2;  // of a remote: both
  static constexpr int actuator2 = 4;

  static int of_remote(const Packet& packet);
  static int of_attendant(const Packet& packet) { return packet.data[6] & 7; }
  static int of_power_module(const Packet& packet) { return packet.data[0] & 7; }
};

struct SpmGeneral {
  explicit SpmGeneral(const Packet& packet);

  bool slowdown;
  int gauge;
  bool drive_inhibited;
  bool power_down_now;
  int state;
  bool locked;
  bool drive_modified;  // of the remote
  bool attendant_modified;
  bool calibrates;  // remote or attendant control
  bool acknowledges_attendant;
  bool system_drives;
  bool cadence;
  bool hazard;
  bool left;
  bool right;
  bool headlight;
  bool lamp_fault;  // any
  bool sleep_requested;
  bool shows_lamps;  // any lamp status or cadence
  bool sacu_drives;
  bool mode_invalid;  // of the remote
  bool attendant_mode_invalid;
  int mode;
  bool has_stray_bits;  // unused ones

  bool is_invalid() const { return mode_invalid || attendant_mode_invalid; }
  // An actuator mode that is in force.
  bool is_actuator_mode() const { return mode >= 1 && mode <= 3 && !is_invalid(); }
};

}  // namespace simulation::monitor
