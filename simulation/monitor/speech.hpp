// What the power module itself says, turn by turn, as it leaves the pin: begin, form, length. And what was heard before
// it, which is all that may make it speak (SB-2.7, SB-2.12, SB-2.13).
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "simulation/monitor/general.hpp"

namespace simulation::monitor {

// The others' turn: everything since the last TF, silence or speech of the power module.
struct Turn {
  std::optional<SrGeneral> general;
  bool has_power_up = false;
  bool is_before_power_up = false;  // no power-up packet was heard since power or reset
  bool has_corrupt = false;
  bool has_factory_test = false;
  bool has_attendant = false;
  bool is_doubtful = false;
  std::optional<Time> begun;     // start of its first character
  std::optional<Time> finished;  // end of its TF
  Time first_end{};
  Time last{};  // end of its last character

  bool has_earned_answer() const { return general || has_power_up; }
};

class Speech {
 public:
  // Power, reset: a turn that was cut there is no fault.
  void forget() { is_open_ = false; }
  // True if the character begins a turn, the answer to `heard`.
  bool take(const BusByte& byte, const Turn& heard);
  // Somebody else speaks at the same time, or wake is asserted: the turn may break off.
  void collide() { is_contended_ = true; }
  bool is_speaking_at(Time time) const { return is_open_ && time < last_; }
  void advance(Time now);

  const Turn& answered() const { return answered_; }
  Time began() const { return began_; }
  // The packet that the last character completed.
  const std::optional<Packet>& packet() const { return packet_; }
  const std::string& flaw() const { return flaw_; }  // of form, since power-up
  bool is_late_or_early() const;                     // outside its slot
  Time on_time() const { return on_time_; }          // within the last 20 ms
  std::string tell() const;

 private:
  void begin(const BusByte& byte, const Turn& heard);
  void measure(const BusByte& byte);
  void put(std::uint8_t value, Time end);
  void begin_packet(std::uint8_t start);
  void complete(std::uint8_t checksum, Time end);
  void blame(const std::string& flaw);

  Turn answered_;
  Time began_{};
  Time last_{};
  bool is_open_ = false;
  bool is_contended_ = false;
  int packets_ = 0;  // of this turn
  int missing_ = 0;  // characters of the packet in progress
  std::uint8_t sum_ = 0;
  Packet draft_;
  std::optional<Packet> packet_;
  std::string flaw_;
  std::deque<BusByte> lately_;
  Time on_time_{};
};

}  // namespace simulation::monitor
