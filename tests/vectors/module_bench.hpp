// One power module with a remote, a line and clocks around it. Every step's outputs go into a record.
#pragma once

#include "spm/spm.hpp"
#include "tests/vectors/random.hpp"
#include "tests/vectors/record.hpp"

namespace vectors {

// A general from the remote, in the words of the wire.
struct General {
  uint8_t speed = 0x40;  // the upper seven bits; 0x40 is neutral
  uint8_t direction = 0x40;
  uint8_t switches = 0;  // data byte 4
  uint8_t answers = 0;   // data byte 5
  uint8_t spoiled = 0;   // into the checksum
};

class ModuleBench {
 public:
  ModuleBench(Record& record, const spm::Settings& settings);

  void wait(uint16_t halves);  // of a millisecond
  // The loop does not come round for so long.
  void stand_still(uint32_t milliseconds);
  void power_up();
  // `count` cycles of 20 ms, the same general in each.
  void generals(const General& general, uint8_t count);
  // A whole packet of any type; `data` without markers.
  void say(bus::shark::Type type, const uint8_t* data, uint8_t length, uint8_t spoiled);
  void hear(uint8_t byte, bool is_spoiled);

  // What else it is told, from now on.
  spm::Inputs& inputs() { return in_; }
  const spm::Spm& spm() const { return spm_; }
  const spm::Outputs& outputs() const { return out_; }
  // A byte of the last turn that was to be said.
  uint8_t said(uint8_t place) const { return said_[place]; }

 private:
  void pass(uint16_t microseconds);
  void step();
  void add_outputs();

  Record& record_;
  spm::Spm spm_;
  spm::Inputs in_;
  spm::Outputs out_;
  base::Instant now_ = base::Instant(0xFFFFF800);  // wraps in two seconds
  uint16_t since_tick_ = 0;
  uint16_t until_said_ = 0;
  uint8_t said_[bus::shark::Turn::capacity] = {};
};

}  // namespace vectors
