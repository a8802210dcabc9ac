// The program, whichever machine it runs on: sense, step, apply, feed.
#pragma once

#include "spm/board.hpp"
#include "spm/spm.hpp"

namespace spm {

class Firmware {
 public:
  // Once after reset, interrupts off. The power latch must already be held.
  void start();

  // One turn of the loop. Nothing lives across turns but the members.
  void pass();

  const Spm& core() const { return spm_; }

 private:
  Board board_;
  Spm spm_;
};

}  // namespace spm
