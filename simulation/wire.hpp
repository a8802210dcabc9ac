// The shared pair between remote, power module and attendant control. Everybody hears everything, himself included,
// sampled by his own clock; whoever is too fast or too slow is misread as a UART would misread him.
//
// Assumptions: time only goes forward; whatever is sent begins now or later; cable and wake do not change twice
// within a character.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/bus_event.hpp"
#include "simulation/time.hpp"
#include "simulation/wire_faults.hpp"
#include "simulation/wire_line.hpp"

namespace simulation {

// A receiver on the wire.
class WireNode {
 public:
  virtual Time bit_time() const = 0;
  virtual void hear(const Reception& reception) = 0;

 protected:
  ~WireNode() = default;
};

class Wire {
 public:
  explicit Wire(std::uint64_t seed) : random_(seed) {}

  // It listens from `now` on, which is not before the wire's own time. A node must outlive the wire or be detached.
  void attach(WireEnd end, WireNode& node, Time now = {});
  void detach(const WireNode& node);
  // Every character once, in order of start, after its first stop bit. It is read at the power module's end.
  void on_byte(std::function<void(const BusByte&)> report) { report_ = std::move(report); }
  void on_wake(std::function<void(bool asserted, Time at)> wake) { tell_wake_ = std::move(wake); }

  void send(Sender sender, std::uint8_t value, Time start, const CharacterFormat& format = {});
  // Back to back.
  void send(Sender sender, const std::vector<std::uint8_t>& values, Time start);

  // SBH above 12 V, by the remote or by a pulse from elsewhere. Nothing is heard meanwhile (SB-1.3).
  void hold_wake(bool asserted, Time now);
  void pulse_wake(Time now, Time span);
  bool is_wake_asserted() const { return line_.wake.is_on(); }

  void cut(Time now);
  void mend(Time now);
  bool is_cut() const { return line_.cut.is_on(); }
  void disturb(const Disturbance& disturbance) { faults_.add(disturbance); }
  // Random characters from the seed, back to back or filling a share of the time, 0 to 1 of it.
  void babble(Time now, Time span, double share = 1);
  // A transmitter that hangs: zeros without a stop bit, back to back.
  void jam(Time now, Time span);

  // When advance() wants to be called; Time::max() while nothing is going on.
  Time next_time() const;
  // Everything up to `now`. All characters that begin before then must have been sent.
  void advance(Time now);

 private:
  static constexpr Time never = Time::max();

  struct Ear {
    WireNode* node = nullptr;
    WireEnd end = WireEnd::remote;
    Time listens_from{};  // for an edge
    Time edge = never;    // the next one, as far as is known; or of the character in progress
    Time bit{};           // of that character
    Time due = never;     // when it has been sampled
  };

  void set_wake(Time now);
  void seek_anew(Time now);
  void put(const Character& character);
  void seek(Ear& ear) const;
  void finish_character(Ear& ear);
  void begin_noise(Time now, Time span, Time spacing, bool is_jam);
  void babble_on();
  void report_until(Time now);
  void report(const Character& character) const;

  Line line_;
  WireFaults faults_;
  std::vector<Ear> ears_;  // in order of their attachment, which is the order of hearing
  std::function<void(const BusByte&)> report_;
  std::function<void(bool, Time)> tell_wake_;
  std::size_t reported_ = 0;  // of the line's characters

  bool is_wake_held_ = false;
  Time pulse_until_ = never;

  std::mt19937_64 random_;
  Time babble_at_ = never;  // the next character
  Time babble_until_{};
  Time babble_spacing_{};
  bool is_jammed_ = false;
};

}  // namespace simulation
