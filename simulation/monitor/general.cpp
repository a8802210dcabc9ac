#include "simulation/monitor/general.hpp"

#include <cstdlib>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

bool bit(const Packet& packet, std::size_t byte, int number) {
  return (packet.data[byte] >> number & 1) != 0;
}

Joystick stick_of(const Packet& packet) {
  Joystick stick;
  stick.end = packet.end;
  stick.is_doubtful = packet.is_doubtful;
  stick.speed = packet.data[0] << 3 | (packet.data[3] >> 3 & 7);
  stick.direction = packet.data[1] << 3 | (packet.data[3] & 7);
  return stick;
}

}  // namespace

SrGeneral::SrGeneral(const Packet& packet)
    : Joystick(stick_of(packet)),
      joystick_error(bit(packet, 4, 6)),
      pot_error(bit(packet, 4, 5)),
      local_fault(bit(packet, 4, 4)),
      charger_inhibit(bit(packet, 4, 3)),
      power_switch(bit(packet, 4, 2)),
      remote_inhibit(bit(packet, 5, 3)),
      calibration(bit(packet, 5, 1)),
      confirm(bit(packet, 5, 0)),
      is_old(packet.length < 7),
      non_critical_fault(!is_old && bit(packet, 6, 5)),
      hazard(!is_old && bit(packet, 5, 6)),
      left(!is_old && bit(packet, 5, 5)),
      right(!is_old && bit(packet, 5, 4)),
      headlight(!is_old && bit(packet, 6, 4)) {
  mode = is_old ? 0 : packet.data[6] & 0x0F;
}

SacuGeneral::SacuGeneral(const Packet& packet)
    : Joystick(stick_of(packet)),
      joystick_error(bit(packet, 4, 6)),
      pot_error(bit(packet, 4, 5)),
      local_fault(bit(packet, 4, 4)),
      calibration(bit(packet, 4, 3)),
      wants_to_drive(bit(packet, 4, 2)),
      non_critical_fault(bit(packet, 4, 1)),
      inhibit(bit(packet, 4, 0)) {
  mode = packet.data[5] & 0x0F;
}

// SB-04.2: with fewer than eight bytes it can do nothing.
int Capabilities::of_remote(const Packet& packet) {
  const int told = packet.length < 8 ? 0 : packet.data[7];
  return (told & 2 ? actuator1 | actuator2 : 0) | (told & 1 ? lighting : 0);
}

bool Joystick::is_neutral() const {
  return std::abs(speed - limits::neutral_reading) <= limits::deadband &&
         std::abs(direction - limits::neutral_reading) <= limits::deadband;
}

SpmGeneral::SpmGeneral(const Packet& packet)
    : slowdown(bit(packet, 0, 5)),
      gauge(packet.data[0] & 0x1F),
      drive_inhibited(bit(packet, 1, 6)),
      power_down_now(bit(packet, 1, 4)),
      state(packet.data[1] & 0x0F),
      locked(bit(packet, 0, 6)),
      drive_modified(bit(packet, 2, 5)),
      attendant_modified(bit(packet, 4, 5)),
      calibrates(bit(packet, 2, 2) || bit(packet, 4, 6)),
      acknowledges_attendant(bit(packet, 4, 4)),
      system_drives(bit(packet, 3, 5)),
      cadence(bit(packet, 3, 4)),
      hazard(bit(packet, 3, 3)),
      left(bit(packet, 3, 2)),
      right(bit(packet, 3, 1)),
      headlight(bit(packet, 3, 0)),
      lamp_fault((packet.data[4] & 0x0F) != 0),
      sleep_requested(bit(packet, 2, 3)),
      shows_lamps((packet.data[3] & 0x1F) != 0),
      sacu_drives(bit(packet, 3, 6)),
      mode_invalid(bit(packet, 5, 4)),
      attendant_mode_invalid(bit(packet, 6, 5)),
      mode(packet.data[5] & 0x0F),
      has_stray_bits(bit(packet, 2, 1) || bit(packet, 6, 6)) {}

}  // namespace simulation::monitor
