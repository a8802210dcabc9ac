// A power module under test, as the world around it sees it: pins, analog inputs, characters, supply.
// board/avr_board runs the flashed image in simavr, board/host_board the same firmware natively.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "simulation/time.hpp"

namespace simulation {

// Levels of the output pins; all false and 0 while unpowered or in reset (external pull-downs).
struct Pins {
  bool power_latch = false;
  bool bridge_enable = false;
  bool motor_relay = false;
  bool left_forward = false;
  bool right_forward = false;
  bool left_brake_release = false;
  bool right_brake_release = false;
  bool left_indicator = false;
  bool right_indicator = false;
  bool headlight = false;
  bool actuator1_extend = false;
  bool actuator1_retract = false;
  bool actuator2_extend = false;
  bool actuator2_retract = false;
  bool status_led = false;
  std::uint16_t left_duty = 0;  // 0 to 511, the PWM compare value in effect
  std::uint16_t right_duty = 0;

  bool operator==(const Pins&) const = default;
};

// What the chair does to the input pins. Analog channels in the order of the port, ADC0 first.
struct Surroundings {
  bool wake = false;
  bool dci_slowdown = false;                                       // true = asked for; the board pulls PB0 low
  bool lighting_fitted = true;                                     // true = strap fitted; PC5 low
  std::array<double, 8> analog_volts{0, 2.5, 2.5, 0, 0, 0, 0, 0};  // at the pins, 0 to 5 V
};

// A character as a receiver with this board's bit clock has sampled it.
struct Reception {
  std::uint8_t value = 0;
  bool framing_error = false;
  Time at{};  // the sampling of the first stop bit
};

enum class ResetKind { power_on, external, brown_out, watchdog };

// A bit of the chip's memory that is not what it should be.
struct Upset {
  enum class Memory { flash, ram };
  Memory memory = Memory::flash;
  std::uint32_t address = 0;
  int bit = 0;                 // 0 to 7
  bool is_stuck_high = false;  // RAM: it stays at that level from now on. A bit of flash flips, once
};

struct BoardStatistics {
  std::uint64_t cycles = 0;  // CPU cycles run; 0 on the host
  std::uint64_t cycles_asleep = 0;
  std::uint32_t resets = 0;             // since power on, the first start excluded
  std::uint32_t overruns = 0;           // characters lost in the UART
  std::vector<std::string> complaints;  // anything that must not happen: wild writes, bad opcodes, crashes
};

class SpmBoard {
 public:
  virtual ~SpmBoard() = default;

  virtual std::string name() const = 0;  // "avr" or "host"

  // Supply on: the firmware starts from a power-on reset at `now`, RAM holding garbage. Off: outputs fall to
  // their pull-downs at once; the EEPROM keeps what was completely written.
  virtual void power(bool on, Time now) = 0;
  virtual bool is_powered() const = 0;
  virtual void reset(ResetKind kind, Time now) = 0;
  virtual void upset(const Upset& upset) = 0;  // outlives resets and the supply

  // Runs the firmware up to `limit`. Comes back early, right after it began a character, so that the world can
  // schedule what that causes. Returns the time reached (for a board without power: `limit`).
  virtual Time run_until(Time limit) = 0;

  // A character has just been received; call in order of time with the board run up to `reception.at`.
  virtual void hear(const Reception& reception) = 0;
  virtual void surround(const Surroundings& surroundings) = 0;

  virtual Pins pins() const = 0;
  virtual Time bit_time() const = 0;  // of this board's UART

  // Called at the moment a character's start bit begins on the transmit pin.
  using Speak = std::function<void(std::uint8_t value, Time start)>;
  virtual void on_speak(Speak speak) = 0;

  virtual std::vector<std::uint8_t> eeprom() const = 0;
  virtual void set_eeprom(const std::vector<std::uint8_t>& contents) = 0;

  virtual BoardStatistics statistics() const = 0;
};

}  // namespace simulation
