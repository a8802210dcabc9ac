#include "spm/spm.hpp"

#include "drivers/base/flash.hpp"

namespace spm {

using namespace base;        // literals
using namespace bus::shark;  // packets

namespace {
constexpr uint8_t longest_catch_up = 5;  // milliseconds done at once after the loop was held up
constexpr Millis longest_wait = 2_ms;    // for the bus, before a millisecond's work is done all the same

// Characters that need no pass of the loop. No packet is complete before its third; TF alone is the transmitter's
// affair and may wait for the next millisecond. A packet that is answered gets a pass shortly before its end, so that
// the last has little left to do.
uint8_t characters_to_let_pass(const Framer& framer) {
  constexpr uint8_t shortest_packet = 3;
  const uint8_t missing = framer.missing();
  if (missing == 0) {
    return shortest_packet;
  }
  const bool is_answered = framer.is_receiving(Type::sr_general) || framer.is_receiving(Type::sr_power_up);
  return is_answered && missing > shortest_packet ? static_cast<uint8_t>(missing - 2) : missing;
}

}  // namespace

const Outputs& Spm::step(const Inputs& in, Instant now) {
  outputs_.are_motors_as_before = outputs_.are_switches_as_before = true;
  if (!outputs_.events.empty()) {
    kept_count_ = 0;
    outputs_.events = Span<const faults::Event>();
  }
  if (!is_started_) {
    start(in, now);
  }
  responder_.begin_step();
  hear(in, now);
  if (link_.poll(now, in.stamp)) {
    has_news_ = true;
  }
  if (has_news_ && !responder_.has_answer()) {
    supervise(now);
  }
  if (!unlogged_.empty() && !responder_.has_answer()) {
    log_faults(in, now);
  }
  do_timed_work(in, now);
  outputs_.is_time_pressing = link_.is_near_silence();
  outputs_.awaited = characters_to_let_pass(framer_);
  outputs_.speech = responder_.speech();
  outputs_.turn = responder_.turn().bytes();
  return outputs_;
}

void Spm::start(const Inputs& in, Instant now) {
  is_started_ = true;
  last_step_ = now;
  settings_sum_ = settings_.sum();
  motion_.configure(settings_);
  sleep_after_ = Millis(settings_[Setting::sleep_timeout] * uint32_t{60000});
  power_.start(now + Millis(0U - in.start_took.count()));  // SB-4.4: from the reset on
  fuel_gauge_.start(now);
  record(EventCode::started, static_cast<uint8_t>(in.start), now);  // SB-3.9
  if (in.settings_copy_bad) {
    record(EventCode::settings_copy_bad, 0, now);
  }
  keep_house(in, now);
  kept_house_ = now + Millis(0U - limits::first_house_keeping.count());
}

void Spm::record_code(uint8_t code, uint8_t argument, Instant now) {
  events_.record(code, argument, now);
  if (kept_count_ < kept_.size()) {
    kept_[kept_count_] = events_.newest(0);
    ++kept_count_;
    outputs_.events = Span<const faults::Event>(kept_.begin(), kept_count_);
  }
}

// ---- hear: bytes to verdicts to packets

void Spm::hear(const Inputs& in, Instant now) {
  if (in.wake) {  // SB-1.3: what is heard now is neither a packet nor a corrupt one
    framer_.reset();
    responder_.hush();
    turn_of_ = Sender::nobody;
    return;
  }
  if (in.echo_differed) {  // SB-1.4
    record(EventCode::echo_differed, 0, now);
  }
  if (in.heard_count == 0 && framer_.is_overdue(in.stamp)) {
    take_verdict(framer_.poll(in.stamp), in, framer_.last_byte(), now);
  }
  for (uint8_t i = 0; i < in.heard_count; ++i) {
    const HeardByte& byte = in.heard[i];
    if (framer_.take_data(byte)) {
      continue;
    }
    const Stamp before = framer_.last_byte();
    const Verdict verdict = framer_.feed(byte);
    if (!verdict.is_empty()) {
      take_verdict(verdict, in, verdict.silence ? before : byte.at, now);
    }
  }
}

void Spm::take_verdict(const Verdict& verdict, const Inputs& in, Stamp at, Instant now) {
  for (uint8_t i = 0; i < verdict.corrupt; ++i) {
    take_corrupt();
  }
  if (verdict.silence) {  // SB-2.12; if it took a byte to notice, somebody else has begun to speak
    end_turn(in, in.stamp - at, in.heard_count == 0 ? limits::latest_after_silence : 0_us, now);
  }
  if (verdict.what == Verdict::What::frame) {
    take_frame(framer_.frame(), at, now);
  } else if (verdict.what == Verdict::What::finished) {
    end_turn(in, in.stamp - at, limits::latest_after_finish, now);
  }
}

void Spm::take_frame(const Frame& frame, Stamp at, Instant now) {
  const Admission admission = admit(frame);
  if (admission == Admission::corrupt) {  // SB-5.3
    take_corrupt();
    return;
  }
  if (link_.has_corrupt_run()) {  // SB-2.14: it counts, even if this very step ends it
    supervise(now);
  }
  link_.sound();  // SB-2.14: an unknown type too ends a run of corrupt packets
  has_news_ = true;
  if (admission == Admission::unknown) {
    return;  // SB-5.1
  }
  switch (static_cast<Type>(frame.type)) {
    case Type::sr_general:
      take_general(frame, at, now);
      break;
    case Type::sr_power_up:
      take_power_up(frame, now);
      break;
    case Type::sr_hhp_data:
      if (phase_ == Phase::running) {  // SB-4.4: in the power-up phase only a power-up packet counts
        power_.heard(now);
        take_hhp_data(decode_sr_hhp_data(frame), now);
      }
      break;
    case Type::joystick_calibration:
      take_calibration(decode_joystick_calibration(frame));
      break;
    case Type::factory_test:
      record(EventCode::factory_test_heard, decode_factory_test(frame).command, now);
      break;  // SB-07.1
    case Type::sacu_general:
      turn_of_ = Sender::attendant;
      attendant_general_ = decode_sacu_general(frame);
      break;
    case Type::sacu_power_up:
      attendant_ = decode_sacu_power_up(frame);
      break;
    default:
      break;
  }
}

void Spm::take_corrupt() {
  if (phase_ != Phase::silent) {  // SB-2.14: counted from the first valid SR power-up packet on
    link_.corrupt();
    has_news_ = true;
  }
}

void Spm::take_power_up(const Frame& frame, Instant now) {
  if (phase_ == Phase::running) {  // SB-3.4
    link_.restarted();
    has_restarted_ = true;
    general_ = SrGeneral();
    forget_others();
  }
  phase_ = Phase::greeting;
  remote_ = decode_sr_power_up(frame);
  power_.heard(now);
  supervise(now);
  answer_power_up();
}

void Spm::take_general(const Frame& frame, Stamp at, Instant now) {
  if (phase_ == Phase::silent) {  // SB-3.1
    return;
  }
  phase_ = Phase::running;  // SB-3.3
  turn_of_ = Sender::remote;
  general_ = decode_sr_general(frame);
  const Millis period = now - general_at_;
  general_at_ = now;
  const PotReading pot = general_.pot_error ? limits::pot_in_error : general_.pot;  // SB-00.6
  motion_.command(Stick{general_.speed, general_.direction, pot});
  if (general_.non_critical_fault) {
    healthy_generals_ = 0;
  } else if (healthy_generals_ < limits::healthy_proof) {
    ++healthy_generals_;
  }

  link_.message(now, at);
  const bool is_resting = motion_.is_stick_at_rest();
  power_.heard(now);
  const bool was_down_asked = power_.is_down_asked();
  power_.general(general_, !is_resting, sleep_after_, now);
  if (power_.is_down_asked() && !was_down_asked) {
    record(EventCode::power_down_asked, power_.is_sleep_asked(), now);
  }
  if (power_.is_bus_idle()) {
    link_.rest();  // SB-2.15
  }
  mode_.request(general_.requested_mode, false);  // SB-3.7: no actuator is fitted in this version
  if (mode_.has_changed()) {
    neutral_.require(true);  // SB-00.7
  }
  neutral_.observe(is_resting);
  // The answer is due: faults that begin count at once, those that end may wait a millisecond.
  const FaultSet present = present_faults();
  if (faults_.are_new(present)) {
    look_for_faults(present, now);
  }
  weigh_inhibits();
  answer_general(period, now);
}

void Spm::take_hhp_data(const HhpData& data, Instant now) {
  programmer_at_ = now;
  is_programmer_active_ = true;
  const bool was_losing = programmer_.is_losing();
  const uint8_t lost = programmer_.hear(data);
  if (lost != 0 && !was_losing) {
    record(EventCode::hhp_data_lost, lost, now);  // SB-02.1
  }
}

// SB-06.1: whose progress it is tells the general that came before it in the same turn.
void Spm::take_calibration(const JoystickCalibration& progress) {
  if (turn_of_ == Sender::remote) {
    remote_calibration_ = progress;
  } else if (turn_of_ == Sender::attendant) {
    attendant_calibration_ = progress;
  }
}

// The remote begins anew, so everybody does.
void Spm::forget_others() {
  programmer_.clear();
  attendant_.reset();
  attendant_general_.reset();
  remote_calibration_ = JoystickCalibration();
  attendant_calibration_ = JoystickCalibration();
}

// ---- supervise: what is wrong, and what it forbids

void Spm::supervise(Instant now) {
  look_for_faults(present_faults(), now);
  weigh_inhibits();
}

// The usual case is that nothing has changed; the walk has a function of its own, so that this does not save its
// registers.
void Spm::look_for_faults(FaultSet present, Instant now) {
  has_news_ = false;
  if (faults_.has_to_walk(present, link_.is_up())) {
    walk_faults(present, now);
  }
  has_restarted_ = false;
}

__attribute__((noinline)) void Spm::walk_faults(FaultSet present, Instant now) {
  unlogged_ = unlogged_ | faults_.update(fault_rows, present, link_.is_up(), now);
}

void Spm::log_faults(const Inputs& in, Instant now) {
  FaultSet fault = FaultSet::first();
  for (uint8_t i = 0; i < fault_count; ++i, fault = fault.next()) {
    const uint8_t event = from_flash(fault_rows[i].event);
    if (unlogged_.has(fault) && event != static_cast<uint8_t>(EventCode::none)) {
      if (fault.has(Fault::internal) && in.has_stack_overrun) {  // H-22
        record(EventCode::stack_overrun, 0, now);
      } else {
        record_code(event, fault.has(Fault::self_test) ? static_cast<uint8_t>(in.self_test) : uint8_t{0}, now);
      }
    }
  }
  unlogged_ = FaultSet();
}

void Spm::weigh_inhibits() {
  // SB-2.17: an emergency stop runs to its end, brakes engaged, however soon the link is back.
  if (faults_.summary().is_transient) {
    stop_is_over_.withhold();
  } else if (!motion_.are_brakes_released()) {
    stop_is_over_.give();
  }
  inhibits_ = present_inhibits();
  if (!inhibits_.empty()) {
    const Inhibits unshown = Inhibits::of(Inhibit::remote_inhibit) | Inhibits::of(Inhibit::charger_inhibit) |
                             Inhibits::of(Inhibit::powering_down);
    neutral_.require(!inhibits_.without(unshown).empty());  // SB-01.8, H-02
  }
  inhibits_.put(Inhibit::awaiting_neutral, neutral_.is_awaited());
}

FaultSet Spm::present_faults() const {
  FaultSet present;
  present.put(Fault::internal, motion_.has_refused() || has_upset_ || do_clocks_differ_);
  present.put(Fault::corrupt_packets, link_.has_corrupt_run());
  present.put(Fault::general_missing, link_.is_silent());
  present.put(Fault::remote_restarted, has_restarted_);
  present.put(Fault::joystick_error, general_.joystick_error);
  present.put(Fault::remote_fault, general_.local_fault);
  present.put(Fault::pot_error, general_.pot_error);
  present.put(Fault::remote_limps, healthy_generals_ < limits::healthy_proof);  // H-06
  present.put(Fault::out_of_neutral, neutral_.is_violated());
  return present | measured_;  // last: what begins empty costs less
}

// What the board says about itself, and how it started: once with every house-keeping is often enough.
FaultSet Spm::faults_of_the_chip(const Inputs& in) {
  FaultSet present;
  present.put(Fault::internal, in.has_stack_overrun);               // H-22
  present.put(Fault::self_test, in.self_test != SelfTest::passed);  // H-27
  present.put(Fault::restart_loop, in.has_restarted_often);         // H-25
  present.put(Fault::unexpected_start, is_unexpected(in.start));    // SB-3.9
  present.put(Fault::settings_lost, in.settings_lost);              // H-20
  return present;
}

Inhibits Spm::present_inhibits() const {
  const faults::Summary& faults = faults_.summary();
  Inhibits present;
  present.put(Inhibit::no_general_yet, phase_ != Phase::running);
  present.put(Inhibit::transient, !stop_is_over_.is_given());
  present.put(Inhibit::fault, faults.must_stop && !faults.is_transient);
  present.put(Inhibit::remote_inhibit, general_.remote_inhibit);  // SB-00.4
  const bool does_charging_yield = settings_[Setting::charging_yields] != 0 && is_programmer_active_;
  present.put(Inhibit::charger_inhibit, general_.charger_inhibit && !does_charging_yield);  // SB-00.5
  present.put(Inhibit::calibration, general_.calibration_active);                           // SB-01.10
  present.put(Inhibit::invalid_mode, !mode_.is_drive());                                    // SB-00.7
  present.put(Inhibit::powering_down, power_.forbids_driving());                            // SB-4.1
  return present;
}

// ---- say: the turn, and when it begins

void Spm::answer_power_up() {
  responder_.open().add(encode(SpmPowerUp()));  // SB-05.1: no lighting, no actuators in this version
  responder_.close();
  until_settings_ = 0;
}

void Spm::answer_general(Millis period, Instant now) {
  if (!responder_.is_earned()) {  // a second general in one turn replaces the answer, it does not make another one
    count_towards_settings(period, now);
  }
  Turn& turn = responder_.open();
  turn.add(encode(report()));  // SB-2.7: general first
  programmer_.add_to(turn, general_.hhp_may_send);
  if (are_settings_due_) {
    turn.add(encode(reported_settings()));
  }
  responder_.close();
}

// SB-0A.1: as often as real modules, but never so late that the answer after this one would exceed the second.
void Spm::count_towards_settings(Millis period, Instant now) {
  are_settings_due_ = until_settings_ == 0 || now - settings_at_ + period > limits::longest_without_settings;
  if (are_settings_due_) {
    until_settings_ = limits::settings_every;
    settings_at_ = now;
  }
  --until_settings_;
}

void Spm::end_turn(const Inputs& in, Micros age, Micros latest, Instant now) {
  turn_of_ = Sender::nobody;
  const bool is_earned = responder_.is_earned();
  // A turn that met somebody else's may be over again before its TF is seen here.
  const bool has_begun = in.speaker == Speaker::speaking || in.echo_differed;
  if (!responder_.finish(has_begun, age, latest)) {  // SB-1.4: given up is given up
    record(EventCode::answer_too_late, 0, now);
  } else if (is_earned) {
    programmer_.left();
  }
}

SpmGeneral Spm::report() const {
  const faults::Summary& faults = faults_.summary();
  SpmGeneral general;
  general.slowdown = faults.is_limping;  // SB-01.1
  general.fuel_gauge = fuel_gauge_.value();
  general.drive_inhibited = !inhibits_.empty();
  general.power_down_now = power_.is_down_asked();
  general.system_state = static_cast<SystemState>(faults.system_state);
  general.lock_mode_enabled = settings_[Setting::lock_mode_enable] != 0;
  general.sr_drive_modified = neutral_.is_shown();  // SB-01.8
  general.sleep_requested = power_.is_sleep_asked();
  general.sound_horn = general_.horn;
  general.system_driving = motion_.is_driving();
  general.sr_mode_invalid = mode_.is_invalid();
  general.operating_mode = mode_.mode();
  general.speedo = motion_.speedo();
  return general;
}

SpmSettings Spm::reported_settings() const {
  SpmSettings reported;
  reported.speedo_option = settings_[Setting::speedo_option] != 0;
  reported.click_on_keypress = settings_[Setting::click_on_keypress] != 0;
  reported.speed_button_sensitivity = narrow<uint8_t>(settings_[Setting::speed_button_sensitivity]);
  reported.joystick_switch_threshold = narrow<uint8_t>(settings_[Setting::joystick_switch_threshold]);
  return reported;
}

// ---- act: motors and brakes once a millisecond, the rest once in ten

// The bus goes first: no work may delay the answer, so it waits while a packet or an answer is near. But no bus puts it
// off for long (H-23).
void Spm::do_timed_work(const Inputs& in, Instant now) {
  const bool is_bus_first = framer_.is_nearly_complete() || responder_.has_answer();
  const Millis late = now - last_step_;
  const bool is_due = late != 0_ms && (!is_bus_first || late > longest_wait);
  if (is_due) {
    move(late, now);
    if (speech_watch_.is_hung(in.speaker, now)) {  // H-30
      record(EventCode::transmitter_hung, 0, now);
      responder_.cut();
    }
  }
  if (is_due && now - kept_house_ >= limits::house_keeping) {
    keep_house(in, now);
  } else if (!is_bus_first && programmer_.has_work()) {
    echo(programmer_);
    programmer_.prepare();
  }
}

void Spm::move(Millis late, Instant now) {
  if (late > Millis(longest_catch_up)) {
    record(EventCode::time_was_lost, narrow<uint8_t>(late > 255_ms ? 255U : late.count()), now);
    last_step_ = now + Millis(0U - uint32_t{longest_catch_up});
  }
  // More than the set needs: each of these is kept twice, so that no flipped bit gives leave (H-27).
  const bool may_drive = inhibits_.empty() && !neutral_.is_awaited() && !faults_.summary().must_stop;
  const Motion::Leave leave{may_drive,
                            faults_.summary().is_limping,
                            now - general_at_,
                            output_watch_.must_cut(),
                            output_watch_.are_bridges_proven(),
                            output_watch_.are_coils_on()};
  while (last_step_ != now) {
    last_step_ = last_step_ + 1_ms;
    motion_.step(leave, last_step_);
  }
  outputs_.left = motion_.demand().left;
  outputs_.right = motion_.demand().right;
  outputs_.left_brake = outputs_.right_brake = motion_.are_brakes_released() ? Brake::released : Brake::engaged;
  outputs_.bridge_enabled = motion_.are_brakes_released();
  outputs_.relay_closed = motion_.are_brakes_released() || may_drive;
  outputs_.are_motors_as_before = false;
  beats_.add(faults::Beat::step);
}

void Spm::keep_house(const Inputs& in, Instant now) {
  kept_house_ = now;
  outputs_.are_switches_as_before = false;
  output_watch_.step(in, outputs_);
  if (battery_.step(in, outputs_, settings_, faults_.active())) {
    motion_.spare_battery(battery_.ceiling(), battery_.faults().has(Fault::over_voltage));
  }
  motion_.watch(in);
  measured_ = output_watch_.faults() | battery_.faults() | faults_of_the_chip(in);
  measured_.put(Fault::stalled, motion_.is_stalled());
  is_programmer_active_ = is_programmer_active_ && now - programmer_at_ < limits::programmer_active;
  check_memory(now);
  compare_clocks(in, now);
  supervise(now);
  fuel_gauge_.step(battery_.at_rest(), settings_, now);
  led_.step(faults_.summary().system_state, now);
  outputs_.status_led = led_.is_on();
  manage_power(in, now);
}

// H-27: what has changed by itself stops the chair, by a ramp that is trusted: it was checked where it is made.
void Spm::check_memory(Instant now) {
  ++houses_;
  const bool is_seldom_due = houses_ % limits::configuration_check == 0;
  uint8_t whose = 0;
  if (!neutral_.is_intact() || !link_.is_intact() || !power_.is_intact() || !stop_is_over_.is_intact() ||
      !output_watch_.is_intact()) {
    whose = 1;
  } else if (!faults_.is_intact()) {
    whose = 2;
    faults_.mend();
  } else if (motion_.has_mended()) {
    whose = 3;
  } else if (is_seldom_due && !motion_.is_configuration_intact()) {
    whose = 4;
    motion_.configure(settings_);
  } else if (is_seldom_due && settings_.sum() != settings_sum_) {
    whose = 5;
    settings_.force_into_range();  // H-21
    settings_sum_ = settings_.sum();
  }
  if (whose != 0 && !has_upset_) {
    has_upset_ = true;
    record(EventCode::upset_found, whose, now);
  }
}

void Spm::compare_clocks(const Inputs& in, Instant now) {
  if (!do_clocks_differ_ && !clock_watch_.agree(now, in.stamp)) {  // H-24
    do_clocks_differ_ = true;
    record(EventCode::clock_differs, 0, now);
  }
}

void Spm::manage_power(const Inputs& in, Instant now) {
  const bool was_leaving = power_.is_leaving();
  const bool is_safe = !motion_.are_brakes_released();
  power_.step(is_safe, in.is_storing, now);
  outputs_.latch = is_safe ? power_.latch() : Latch::hold;  // SB-4.5, whatever the memory says (H-27)
  if (power_.is_leaving() && !was_leaving) {
    if (power_.is_remote_gone()) {  // SB-4.4: the latch does not wait until that is written
      events_.record(static_cast<uint8_t>(EventCode::powered_down), 1, now);
    } else {
      record(EventCode::powered_down, 0, now);
    }
  }
  if (is_safe && power_.is_off() && in.wake && !was_wake_) {
    *this = Spm(settings_);  // woken again before the supply had died: begin anew
    return;
  }
  was_wake_ = in.wake;
}

}  // namespace spm
