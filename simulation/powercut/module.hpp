// The power module on a table: the flashed image with a supply that can be cut at any byte that it writes, and a remote
// that asks at the end how it is.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"
#include "simulation/eeprom/layout.hpp"
#include "simulation/powercut/outcome.hpp"

namespace simulation::powercut {

struct Cut {
  int write = 0;  // which byte since this start, counted from 0
  Outcome outcome;
};

// What the remote was answered.
struct Answer {
  bool is_whole = false;  // a power-up packet, a general and settings, each as it must be
  bool limps = false;
  int system_state = 0;
  int speed_button_sensitivity = 0;
  int joystick_switch_threshold = 0;
};

class Module {
 public:
  // Throws std::runtime_error if the image cannot be used.
  explicit Module(const std::string& image);

  void set_eeprom(const eeprom::Bytes& contents) { board_->set_eeprom(contents); }
  eeprom::Bytes eeprom() const { return board_->eeprom(); }

  // A start whose supply is cut at that byte; false, and the start is complete, if it does not write so many.
  bool start_and_cut(const Cut& cut);
  // A start to its end: until nothing more is written and the remote has been answered.
  Answer start();

  // The bytes that the last start wrote, in order; of a cut one without the last.
  const std::vector<EepromWrite>& writes() const { return writes_; }
  // Anything that was seen on pins, bus or chip since this was asked last, and must not be; empty if all was well.
  std::string take_mischief();
  int starts() const { return starts_; }
  double simulated() const { return seconds(now_); }

 private:
  void power_on();
  void power_off();
  void run_until(Time limit);
  // Runs to the end of what is written, or to the byte that is to be cut.
  bool run_to_rest(const Cut* cut);
  void say(const std::vector<std::uint8_t>& bytes);
  void look_at_pins();

  std::unique_ptr<AvrBoard> board_;
  Time now_{};
  int starts_ = 0;
  std::vector<EepromWrite> writes_;
  std::vector<std::uint8_t> heard_;
  std::string mischief_;
};

}  // namespace simulation::powercut
