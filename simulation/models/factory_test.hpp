// What a remote and an attendant control have for the factory: another device reads and writes their memory by packets
// of type 07, in a system without a power module (SB-07.1).
//
// Memory: one data space, as the chip's. Register space shows its addresses 0x000 to 0x0FF as they are, static RAM
// space the same data from 0x060 on, by page: what is written to register 0x70 is read as RAM 0x10 of page 0. The
// registers have no effect. The EEPROM alone outlives a reset.
//
// Assumptions, where the document leaves it open: a packet with less than 3 data bytes is not answered. Of two requests
// in a turn both are done and the last is answered. Nobody is behind any other device than 0: while one of them is
// selected, only a selection is answered.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/time.hpp"

namespace simulation {

class FactoryTest {
 public:
  enum class Module : std::uint8_t { remote = 0, attendant_control = 1 };  // the packet's module-select flag

  // With an erased EEPROM.
  explicit FactoryTest(Module module) : module_(module) { eeprom_.fill(0xFF); }

  // A character whose stop bits ended at `ended`: the other's turn goes on, silence has to begin anew.
  void hear_character(Time ended);
  // Somebody speaks in this module's place until then, so that no request is to it.
  void ignore_until(Time until) { ignored_until_ = until; }
  // A whole packet of type 07, marker bits stripped, heard after its last character. True: the module resets, at once.
  bool take(const std::vector<std::uint8_t>& data, Time ended);
  // The other's TF.
  void hear_end_of_turn(Time ended);

  // When the answer is due; Time::max() while there is none.
  Time due() const { return due_; }
  // The answer and TF, once.
  std::vector<std::uint8_t> take_answer();

  // After a reset, and after power on.
  void begin_anew();

 private:
  static constexpr Time never = Time::max();
  static constexpr std::size_t data_space = 0x460;

  struct Request {
    int command;
    int address;
    int data;
  };

  bool is_answered(int command) const;
  std::optional<std::uint8_t> carry_out(const Request& request);
  std::uint8_t& ram(int address) { return data_space_[static_cast<std::size_t>(0x60 + (page_ << 8) + address)]; }
  std::uint8_t set_page(int page);

  Module module_;
  std::array<std::uint8_t, data_space> data_space_{};
  std::array<std::uint8_t, 256> eeprom_{};
  int page_ = 0;
  int device_ = 0;
  std::vector<std::uint8_t> answer_;  // empty: none
  Time due_ = never;
  Time ignored_until_ = -1ms;
};

}  // namespace simulation
