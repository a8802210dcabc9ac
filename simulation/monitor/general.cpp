#include "simulation/monitor/general.hpp"

#include <cstdlib>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

bool bit(const Packet& packet, std::size_t byte, int number) {
  return (packet.data[byte] >> number & 1) != 0;
}

}  // namespace

SrGeneral::SrGeneral(const Packet& packet)
    : end(packet.end),
      is_doubtful(packet.is_doubtful),
      speed(packet.data[0] << 3 | (packet.data[3] >> 3 & 7)),
      direction(packet.data[1] << 3 | (packet.data[3] & 7)),
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
      mode(is_old ? 0 : packet.data[6] & 0x0F) {}

bool SrGeneral::is_neutral() const {
  return std::abs(speed - limits::neutral_reading) <= limits::deadband &&
         std::abs(direction - limits::neutral_reading) <= limits::deadband;
}

SpmGeneral::SpmGeneral(const Packet& packet)
    : slowdown(bit(packet, 0, 5)),
      gauge(packet.data[0] & 0x1F),
      drive_inhibited(bit(packet, 1, 6)),
      power_down_now(bit(packet, 1, 4)),
      state(packet.data[1] & 0x0F),
      drive_modified(bit(packet, 2, 5)),
      sleep_requested(bit(packet, 2, 3)),
      shows_lamps((packet.data[3] & 0x1F) != 0),
      sacu_drives(bit(packet, 3, 6)),
      mode_invalid(bit(packet, 5, 4)),
      mode(packet.data[5] & 0x0F),
      has_stray_bits(bit(packet, 2, 1) || bit(packet, 6, 6)) {}

}  // namespace simulation::monitor
