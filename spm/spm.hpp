// The power module: one object, one step. Everything it is told comes in Inputs, everything it does leaves in
// Outputs; the order of work is step(), top to bottom.
#pragma once

#include <stdint.h>

#include "bus/shark/codec.hpp"
#include "bus/shark/framer.hpp"
#include "bus/shark/packet_table.hpp"
#include "bus/shark/packets.hpp"
#include "bus/shark/responder.hpp"
#include "drivers/base/grant.hpp"
#include "faults/clock_watch.hpp"
#include "faults/event.hpp"
#include "faults/heartbeat.hpp"
#include "faults/link_supervisor.hpp"
#include "faults/manager.hpp"
#include "spm/battery.hpp"
#include "spm/events.hpp"
#include "spm/fault_rules.hpp"
#include "spm/fuel_gauge.hpp"
#include "spm/inhibit.hpp"
#include "spm/inputs.hpp"
#include "spm/limits.hpp"
#include "spm/motion.hpp"
#include "spm/neutral.hpp"
#include "spm/operating_mode.hpp"
#include "spm/output_watch.hpp"
#include "spm/outputs.hpp"
#include "spm/power.hpp"
#include "spm/programmer.hpp"
#include "spm/settings.hpp"
#include "spm/speech_watch.hpp"
#include "spm/status_led.hpp"

namespace spm {

// Where the power-up handshake stands (section 3).
enum class Phase : uint8_t {
  silent,    // no SR power-up packet heard since reset (SB-3.1)
  greeting,  // SR power-up packets are answered with ours (SB-3.2)
  running,   // generals are answered with generals (SB-3.3)
};

class Spm {
 public:
  constexpr explicit Spm(const Settings& settings = Settings())
      : settings_(settings), link_(limits::link), neutral_(limits::neutral_proof) {}

  // Before the first step.
  void use(const Settings& settings) { settings_ = settings; }

  // Everything that happens in the power module, once for each event: at every heard byte, every 500 us and every
  // millisecond. `now` never goes back. The work of a millisecond is done once, by the first step that sees it.
  // The outputs stand until the next step.
  const Outputs& step(const Inputs& in, base::Instant now);

  // H-25: what was done since this was last asked.
  faults::Beats take_beats() {
    const faults::Beats done = beats_;
    beats_ = faults::Beats();
    return done;
  }

  // For the console, the log and tests.
  Phase phase() const { return phase_; }
  Inhibits inhibits() const { return inhibits_; }
  const faults::Summary& faults() const { return faults_.summary(); }
  FaultSet active_faults() const { return faults_.active(); }
  const faults::EventRing& events() const { return events_; }
  const bus::shark::SrPowerUp& remote() const { return remote_; }
  const bus::shark::JoystickCalibration& remote_calibration() const { return remote_calibration_; }
  // The attendant control, as far as it was heard since the remote began.
  const base::Optional<bus::shark::SacuPowerUp>& attendant() const { return attendant_; }
  const base::Optional<bus::shark::SacuGeneral>& attendant_general() const { return attendant_general_; }
  const bus::shark::JoystickCalibration& attendant_calibration() const { return attendant_calibration_; }
  const Programmer& programmer() const { return programmer_; }
  const Settings& settings() const { return settings_; }

 private:
  void start(const Inputs& in, base::Instant now);

  void hear(const Inputs& in, base::Instant now);
  void take_verdict(const bus::shark::Verdict& verdict, const Inputs& in, base::Stamp at, base::Instant now);
  void take_frame(const bus::shark::Frame& frame, base::Stamp at, base::Instant now);
  void take_power_up(const bus::shark::Frame& frame, base::Instant now);
  void take_general(const bus::shark::Frame& frame, base::Stamp at, base::Instant now);
  void take_hhp_data(const bus::shark::HhpData& data, base::Instant now);
  void take_calibration(const bus::shark::JoystickCalibration& progress);
  void take_corrupt();
  void forget_others();

  void supervise(base::Instant now);
  void look_for_faults(FaultSet present, base::Instant now);
  void walk_faults(FaultSet present, base::Instant now);
  void log_faults(const Inputs& in, base::Instant now);
  void weigh_inhibits();
  FaultSet present_faults() const;
  static FaultSet faults_of_the_chip(const Inputs& in);
  Inhibits present_inhibits() const;

  void answer_general(base::Millis period, base::Instant now);
  void count_towards_settings(base::Millis period, base::Instant now);
  void answer_power_up();
  bus::shark::SpmGeneral report() const;
  bus::shark::SpmSettings reported_settings() const;
  void end_turn(const Inputs& in, base::Micros age, base::Micros latest, base::Instant now);

  void do_timed_work(const Inputs& in, base::Instant now);
  void move(base::Millis late, base::Instant now);
  void keep_house(const Inputs& in, base::Instant now);
  void check_memory(base::Instant now);
  void manage_power(const Inputs& in, base::Instant now);
  void compare_clocks(const Inputs& in, base::Instant now);

  void record(EventCode code, uint8_t argument, base::Instant now) {
    record_code(static_cast<uint8_t>(code), argument, now);
  }
  void record_code(uint8_t code, uint8_t argument, base::Instant now);

  Settings settings_;

  bus::shark::Framer framer_;
  bus::shark::Responder responder_;

  Phase phase_ = Phase::silent;
  faults::LinkSupervisor link_;
  bus::shark::SrPowerUp remote_;
  bus::shark::SrGeneral general_;
  base::Instant general_at_;
  bus::shark::Sender turn_of_ = bus::shark::Sender::nobody;  // whose general the turn being heard began with
  bus::shark::JoystickCalibration remote_calibration_;
  base::Optional<bus::shark::SacuPowerUp> attendant_;
  base::Optional<bus::shark::SacuGeneral> attendant_general_;
  bus::shark::JoystickCalibration attendant_calibration_;
  Programmer programmer_;
  base::Instant programmer_at_;        // when it last sent something
  bool is_programmer_active_ = false;  // not long ago (SB-00.5)
  bool has_news_ = false;              // something was heard that the fault rows have not seen
  bool has_restarted_ = false;         // SB-3.4, until the fault rows have seen it
  OperatingMode mode_;
  Neutral neutral_;
  uint8_t healthy_generals_ = limits::healthy_proof;  // in a row, without the remote's non-critical fault
  uint8_t until_settings_ = 0;                        // generals until the next settings packet
  base::Instant settings_at_;                         // when the last one was said
  bool are_settings_due_ = false;

  faults::Manager<Fault, fault_count, FaultBits> faults_;
  FaultSet measured_;                                          // what is looked at with every house-keeping
  FaultSet unlogged_;                                          // begun, not yet in the log: an answer went first
  base::Grant stop_is_over_{true};                             // no emergency stop is on its way (SB-2.17)
  Inhibits inhibits_ = Inhibits::of(Inhibit::no_general_yet);  // never empty before it has been weighed
  faults::EventRing events_;
  base::Array<faults::Event, 4> kept_ = {};  // those of this step that outlive the supply
  uint8_t kept_count_ = 0;

  Motion motion_;
  OutputWatch output_watch_;
  faults::Beats beats_;
  faults::ClockWatch clock_watch_;
  bool do_clocks_differ_ = false;  // H-24, until the supply goes
  SpeechWatch speech_watch_;
  Power power_;
  base::Millis sleep_after_;  // SB-4.2: made once, a product costs every answer 5 us
  Battery battery_;
  FuelGauge fuel_gauge_;
  StatusLed led_;

  bool is_started_ = false;
  bool was_wake_ = true;
  base::Instant last_step_;    // of the motors
  base::Instant kept_house_;   // last time of the slower rest
  uint8_t houses_ = 0;         // times it was kept, for what is done less often
  uint16_t settings_sum_ = 0;  // as they were when they were given (H-27)
  bool has_upset_ = false;     // memory has changed by itself
  Outputs outputs_;
};

}  // namespace spm
