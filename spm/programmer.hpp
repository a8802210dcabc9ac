// The hand-held programmer behind the remote, as two streams of characters: what it sends arrives in packets of type
// 02, what it shall show leaves in packets of type 03, both in order (SB-02.1, SB-03.1).
//
//   type 02 --hear--> input --take--> [echo, one day the console] --put--> output --prepare--> packet --add_to--> turn
//
// take(), put() and room() are the seam where the console will sit; until it exists, echo() does.
//
// Goals: nothing is lost while there is room; the answer never waits for a packet to be made.
// Assumptions: each add_to() is followed by left() if that turn was said, before the next turn is made.
// Invariants: no character is said twice, none above 0x7F at all; output holds what is in packet_ until that was said.
#pragma once

#include <stdint.h>

#include "bus/shark/frame.hpp"
#include "bus/shark/packets.hpp"
#include "bus/shark/turn.hpp"
#include "drivers/base/queue.hpp"

namespace spm {

class Programmer {
 public:
  static constexpr uint8_t input_size = 64;
  static constexpr uint8_t output_size = 128;

  constexpr Programmer() {}

  // ---- for the console

  // The next character from the programmer; false if there is none.
  bool take(char& character);
  // To the programmer. False, and nothing said, without room or for a code above 0x7F (SB-03.2).
  bool put(char character);
  // So many characters more will be accepted.
  uint8_t room() const { return output_.room(); }

  // ---- for the bus

  // How many of these characters found no room and are lost.
  uint8_t hear(const bus::shark::HhpData& data);
  // Begins when characters are lost, lasts until all that could be kept has been taken: one thing to log.
  bool is_losing() const { return is_losing_; }
  // Characters lost since the start, 65535 of them at most.
  uint16_t lost() const { return lost_; }

  // Something to read, or to make a packet of.
  bool has_work() const { return !input_.empty() || (packed_ < bus::shark::longest_data && output_.size() > packed_); }
  // Makes the next packet, in time that nobody waits for.
  void prepare();
  // Adds the packet to an answer, if there is one and the remote has room for it.
  void add_to(bus::shark::Turn& turn, bool may_send) {
    is_in_turn_ = may_send && packed_ != 0 && turn.add(packet_);  // SB-03.1
  }
  // The turn that was made last was said; whether anybody heard it is not our concern (SB-2.9).
  void left() {
    if (is_in_turn_) {
      is_in_turn_ = false;
      output_.drop(packed_);
      packed_ = 0;
    }
  }

  // Forgets what is on its way, as when a remote begins anew.
  void clear();

 private:
  base::Queue<char, input_size> input_;
  base::Queue<char, output_size> output_;
  bus::shark::Frame packet_;
  uint8_t packed_ = 0;       // characters of output_ that are in packet_ as well
  bool is_in_turn_ = false;  // packet_ is part of the turn that was made last
  bool is_losing_ = false;
  uint16_t lost_ = 0;
};

// A terminal for want of a console: what is typed comes back, printable characters as they are (the programmer's own
// four, 0x10 to 0x13, among them), a carriage return with a line feed; anything else is dropped. Does a few characters
// at a time.
void echo(Programmer& programmer);

}  // namespace spm
