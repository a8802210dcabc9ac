// Everything the monitor knows at one moment; what its clauses are asked of. It knows what a person with an
// oscilloscope on wires and pins, and a clamp around each motor's wire, can know: characters, wake, supply, pins,
// currents, and that the chip was reset. Neither the
// firmware's state nor the chair's movement, nor what a scenario intends.
#pragma once

#include <optional>
#include <string>

#include "simulation/monitor/actuators.hpp"
#include "simulation/monitor/attendant.hpp"
#include "simulation/monitor/ear.hpp"
#include "simulation/monitor/general.hpp"
#include "simulation/monitor/lamps.hpp"
#include "simulation/monitor/leave.hpp"
#include "simulation/monitor/speech.hpp"
#include "simulation/monitor/stick.hpp"
#include "simulation/monitor/supply.hpp"
#include "simulation/monitor/wheels.hpp"

namespace simulation::monitor {

// A fall that something has begun: from how high, and when.
struct Fall {
  Time from{};
  int largest = 0;
  Reason reason = Reason::neutral;
};

// LIMP, as far as it can be seen.
struct Limp {
  std::optional<Time> caused;  // the first certain cause that lasts until power-down
  std::optional<Time>
      non_critical;          // since when the remote has set its non-critical fault, until five generals without
  int clean_generals = 100;  // in a row, without that fault
  std::optional<Time> of_attendant;  // since when the attendant control sets its own
  int clean_answers = 100;           // in a row, to generals without that fault
  bool is_latched_as_told = false;   // the power module has told of a LIMP that only power-down ends
};

// Who spoke the character that is being judged, and what came of it.
struct Said {
  bool begins_turn = false;
  std::optional<SpmGeneral> general;
  std::optional<Packet> packet;
  BusByte byte;
};

class Scene {
 public:
  Scene();

  // In order of time. The first returns true if it was the power module that spoke.
  bool take(const BusByte& byte);
  void take_wake(bool is_asserted, Time at);
  void take_power(bool is_powered, Time at);
  void take(const Sample& sample);

  Time now{};
  bool is_powered = false;
  bool was_reset = false;  // since the sample before
  std::optional<Time> wake_since;
  Wheels wheels;
  Leave leave;
  Supply supply;
  Attendant attendant;
  Stick stick;
  Actuators actuators;
  Lamps lamps;
  Speech speech;
  Said said;
  Limp limp;
  std::optional<Fall> fall;
  std::optional<Time> told_inhibited;  // by the power module, and no general since
  std::optional<Time> old_since;       // the remote sends six data bytes
  std::optional<SpmGeneral> report;    // the power module's last, and the one before it
  std::optional<SpmGeneral> report_before;
  // Of both packets together; since when there is no lighting.
  std::optional<int> own_capabilities;  // as it has told them
  int remote_capabilities = 0;
  std::optional<Time> unlit_since;

  // Since the last general; very long if there was none.
  Time silence() const;
  // A reason has held longer than the power module may need to act on it, at both of the last samples.
  bool is_denied(Reason reason) const;
  bool is_denied() const;
  // The module that drives has done so for longer than a turn when the power module began to speak.
  bool drove(Driver driver) const;
  std::string tell() const;

 private:
  void begin_anew(Time at);
  void forget_turns();
  void hear(const Packet& packet);
  void hear_packet(const Packet& packet);
  void hear_general(const SrGeneral& packet);
  void hear_attendant(const SacuGeneral& packet);
  void hear_attendants_power_up(const Packet& packet);
  void obey_change_of_driver(Time at);
  void read_limp(const SrGeneral& packet);
  void read_own_power_up(const Packet& packet);
  void judge_lighting(Time at);
  void read_report(const SpmGeneral& packet, const Turn& answered);
  void follow_fall();
  void take_own(const BusByte& byte);
  void take_other(const BusByte& byte);
  // What the power module answers if it begins to speak at `start`: a character that has not ended then it cannot have
  // known of.
  const Turn& turn_known_at(Time start) const { return turn_.begun && turn_.first_end > start ? turn_before_ : turn_; }

  std::optional<Time> remote_heard_;  // generals
  std::optional<Time> attendant_heard_;
  Ear ear_;
  Turn turn_;
  Turn turn_before_;
  bool is_turn_over_ = true;
  std::uint32_t resets_ = 0;
};

}  // namespace simulation::monitor
