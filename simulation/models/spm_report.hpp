// What a module has understood from the SPM's last valid general packet (SB-01.1 to SB-01.7).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simulation/time.hpp"

namespace simulation {

struct SpmReport {
  static constexpr std::size_t length = 7;

  std::array<std::uint8_t, length> data{};  // marker bits stripped
  Time at{};                                // end of the packet; 0 = none yet

  bool is_locked() const { return bit(0, 6); }
  bool is_slowed() const { return bit(0, 5); }  // DCI slowdown or limp
  int fuel_gauge() const { return data[0] & 0x1F; }
  bool is_drive_inhibited() const { return bit(1, 6); }
  bool is_power_down_now() const { return bit(1, 4); }
  int system_state() const { return data[1] & 0x0F; }
  bool is_drive_modified() const { return bit(2, 5); }
  bool is_sleep_requested() const { return bit(2, 3); }
  bool is_calibrating() const { return bit(2, 2); }
  bool sounds_horn() const { return bit(2, 0); }
  bool is_sacu_driving() const { return bit(3, 6); }
  bool is_driving() const { return bit(3, 5); }
  bool is_sacu_calibrating() const { return bit(4, 6); }
  bool is_sacu_drive_modified() const { return bit(4, 5); }
  bool is_sacu_acknowledged() const { return bit(4, 4); }
  bool is_mode_invalid() const { return bit(5, 4); }
  int operating_mode() const { return data[5] & 0x0F; }
  bool is_sacu_mode_invalid() const { return bit(6, 5); }
  int speedo() const { return data[6] & 0x1F; }

 private:
  bool bit(std::size_t byte, int number) const { return ((data[byte] >> number) & 1) != 0; }
};

}  // namespace simulation
