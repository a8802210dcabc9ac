// The program, whichever machine it runs on: sense, step, apply, store, feed.
#pragma once

#include "drivers/base/time.hpp"
#include "faults/heartbeat.hpp"
#include "spm/board.hpp"
#include "spm/spm.hpp"
#include "spm/storage.hpp"

namespace spm {

class Firmware {
 public:
  // Once after reset, interrupts off. The power latch must already be held (SB-1.2).
  void start();

  // One turn of the loop. Nothing lives across turns but the members.
  void pass();

  const Spm& core() const { return spm_; }
  const Storage& storage() const { return storage_; }

 private:
  void stay_alive(base::Stamp stamp);

  Board board_;
  Spm spm_;
  Storage storage_;
  faults::Heartbeat heartbeat_;
  base::Instant last_;
  bool is_second_ = false;  // of two milliseconds
};

}  // namespace spm
