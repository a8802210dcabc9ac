#include "simulation/scenario/hands.hpp"

#include <fmt/format.h>

#include <array>

#include "simulation/report/decode.hpp"
#include "simulation/report/packet.hpp"
#include "simulation/scenario/quantity.hpp"

namespace simulation::scenario {
namespace {

template <typename Controls>
struct SwitchRow {
  bool Controls::*member;
  const char* on;
  const char* off;
};

constexpr std::array switches{
    SwitchRow{&RemoteControls::power_button, "the driver presses the power button",
              "the driver lets go of the power button"},
    SwitchRow{&RemoteControls::horn, "the driver sounds the horn", "the driver ends the horn"},
    SwitchRow{&RemoteControls::lock, "the driver locks the chair", "the driver unlocks the chair"},
    SwitchRow{&RemoteControls::hazard, "the driver asks for the hazard light", "the driver ends the hazard light"},
    SwitchRow{&RemoteControls::left_indicator, "the driver indicates left", "the driver ends the left indicator"},
    SwitchRow{&RemoteControls::right_indicator, "the driver indicates right", "the driver ends the right indicator"},
    SwitchRow{&RemoteControls::headlight, "the driver asks for the headlight", "the driver ends the headlight"},
    SwitchRow{&RemoteControls::joystick_error, "the remote reports a joystick error", "the joystick error is over"},
    SwitchRow{&RemoteControls::pot_error, "the remote reports a pot error", "the pot error is over"},
    SwitchRow{&RemoteControls::local_fault, "the remote reports a fault of its own", "the remote's fault is over"},
    SwitchRow{&RemoteControls::non_critical_fault, "the remote reports a non-critical fault",
              "the remote's non-critical fault is over"},
    SwitchRow{&RemoteControls::charger_inhibit, "a charger is plugged in", "the charger is unplugged"},
    SwitchRow{&RemoteControls::remote_inhibit, "the remote forbids driving", "the remote allows driving"},
    SwitchRow{&RemoteControls::calibration_active, "joystick calibration begins", "joystick calibration ends"},
    SwitchRow{&RemoteControls::calibration_second_pass, "the second pass of calibration begins",
              "the second pass of calibration ends"},
    SwitchRow{&RemoteControls::hhp_may_send, "the programmer's tunnel is open", "the programmer's tunnel is shut"},
};

constexpr std::array sacu_switches{
    SwitchRow{&SacuControls::is_attendant, "the attendant takes over", "the attendant hands back"},
    SwitchRow{&SacuControls::joystick_error, "the attendant control reports a joystick error",
              "the attendant's joystick error is over"},
    SwitchRow{&SacuControls::pot_error, "the attendant control reports a pot error",
              "the attendant's pot error is over"},
    SwitchRow{&SacuControls::local_fault, "the attendant control reports a fault of its own",
              "the attendant control's fault is over"},
    SwitchRow{&SacuControls::non_critical_fault, "the attendant control reports a non-critical fault",
              "the attendant control's non-critical fault is over"},
    SwitchRow{&SacuControls::calibration_active, "the attendant's joystick calibration begins",
              "the attendant's joystick calibration ends"},
    SwitchRow{&SacuControls::calibration_second_pass, "the second pass of the attendant's calibration begins",
              "the second pass of the attendant's calibration ends"},
    SwitchRow{&SacuControls::drive_inhibit, "the attendant control forbids driving",
              "the attendant control allows driving"},
};

constexpr int neutral = RemoteControls{}.speed;

template <typename Controls>
bool is_stick_at(const Controls& controls, int speed, int direction) {
  return controls.speed == speed && controls.direction == direction;
}

struct Names {
  const char* person;
  const char* module;
};

// For the remote's controls and for the attendant's.
template <typename Controls, typename Switches>
std::vector<std::string> tell_changes(const Names& names, const Switches& switches, const Controls& before,
                                      const Controls& now) {
  std::vector<std::string> deeds;
  if (!is_stick_at(now, before.speed, before.direction)) {
    deeds.push_back(
        fmt::format("{} {} the stick", names.person, is_stick_at(now, neutral, neutral) ? "lets go of" : "moves"));
  }
  if (now.pot != before.pot) {
    deeds.push_back(fmt::format("{} turns the speed pot", names.person));
  }
  for (const auto& row : switches) {
    if (now.*row.member != before.*row.member) {
      deeds.emplace_back(now.*row.member ? row.on : row.off);
    }
  }
  if (now.mode != before.mode) {
    deeds.push_back(fmt::format("{} asks for mode {}", names.module, now.mode));
  }
  return deeds;
}

std::string join(const std::vector<std::string>& deeds) {
  return fmt::format("{}", fmt::join(deeds, ", "));
}

std::string show_time(Time time) {
  return show(seconds(time), Measure::time);
}

// "the next 3 SR generals"
std::string name_of_victims(const Disturb& disturb) {
  const auto* packet = report::find_packet(disturb.start_nibble);
  const std::string name = report::name_of(disturb.sender) + " " + (packet == nullptr ? "TF" : packet->name);
  if (disturb.count == 1) {
    return "the next " + name;
  }
  return fmt::format("the next {} {}{}", disturb.count, name, name.ends_with('s') ? "" : "s");
}

Disturbance disturbance_of(const Disturb& disturb) {
  Disturbance disturbance;
  switch (disturb.way) {
    case Disturb::Way::corrupt_checksum:
      disturbance.way = Disturbance::Way::corrupt_checksum;
      break;
    case Disturb::Way::flip_bit:
      disturbance.way = Disturbance::Way::flip_bit;
      break;
    case Disturb::Way::drop:
      disturbance.way = Disturbance::Way::drop;
      break;
    case Disturb::Way::framing_error:
      disturbance.way = Disturbance::Way::framing_error;
      break;
    case Disturb::Way::late_byte:
      disturbance.way = Disturbance::Way::late_byte;
      break;
  }
  disturbance.sender = disturb.sender;
  disturbance.type = disturb.start_nibble;
  disturbance.byte = disturb.byte;
  disturbance.bit = disturb.bit;
  disturbance.by = disturb.by;
  disturbance.count = disturb.count;
  return disturbance;
}

}  // namespace

std::string Hands::press_power(bool down) {
  world_.remote().controls.power_button = down;
  if (!down) {
    return "";
  }
  world_.remote().start(world_.now());
  return "the driver presses the power button";
}

std::string Hands::apply(const SetControls& controls) {
  RemoteControls& now = world_.remote().controls;
  const RemoteControls before = now;
  for (const auto& change : controls.changes) {
    change(now);
  }
  return join(tell_changes({"the driver", "the remote"}, switches, before, now));
}

std::string Hands::apply(const SetRemote& changes) {
  Remote& remote = world_.remote();
  std::vector<std::string> deeds;
  if (changes.talks && *changes.talks == remote.is_silent) {
    remote.is_silent = !*changes.talks;
    deeds.emplace_back(*changes.talks ? "the remote talks again" : "the remote falls silent");
  }
  if (changes.period) {
    remote.timing.period = *changes.period;
    deeds.push_back(fmt::format("the remote sends every {}", show_time(*changes.period)));
  }
  for (const auto& change : changes.changes) {
    change(remote.identity);
  }
  if (!changes.changes.empty()) {
    deeds.emplace_back("the remote is of another kind");
  }
  for (const auto& habit : changes.habits) {
    habit.change(remote);
    deeds.push_back(habit.deed);
  }
  return join(deeds);
}

std::string Hands::apply(const SetSacu& changes) {
  Sacu& sacu = world_.sacu();
  const SacuControls before = sacu.controls;
  for (const auto& change : changes.changes) {
    change(sacu.controls);
  }
  auto deeds = tell_changes({"the attendant", "the attendant control"}, sacu_switches, before, sacu.controls);
  for (const auto& habit : changes.habits) {
    habit.change(sacu);
    deeds.push_back(habit.deed);
  }
  if (changes.is_attached && *changes.is_attached != sacu.is_attached()) {
    *changes.is_attached ? world_.attach_sacu() : world_.detach_sacu();
    deeds.emplace_back(*changes.is_attached ? "an attendant control is plugged in"
                                            : "the attendant control is unplugged");
  }
  return join(deeds);
}

std::string Hands::apply(const UseProgrammer& use) {
  Programmer& programmer = world_.remote().programmer;
  if (use.clears) {
    programmer.clear_screen();
    return "";
  }
  programmer.type(use.types);
  return fmt::format("the programmer sends {}", report::quote(use.types));
}

std::string Hands::apply(const CutCable&) {
  world_.wire().cut(world_.now());
  return "the cable is cut";
}

std::string Hands::apply(const MendCable&) {
  world_.wire().mend(world_.now());
  return "the cable is mended";
}

std::string Hands::apply(const Disturb& disturb) {
  world_.wire().disturb(disturbance_of(disturb));
  const std::string victims = name_of_victims(disturb);
  switch (disturb.way) {
    case Disturb::Way::corrupt_checksum:
      return fmt::format("noise changes the checksum of {}", victims);
    case Disturb::Way::flip_bit:
      return fmt::format("noise flips bit {} of byte {} of {}", disturb.bit, disturb.byte, victims);
    case Disturb::Way::framing_error:
      return fmt::format("noise breaks the stop bit of byte {} of {}", disturb.byte, victims);
    case Disturb::Way::late_byte:
      return fmt::format("byte {} of {} comes {} late", disturb.byte, victims, show_time(disturb.by));
    case Disturb::Way::drop:
      break;
  }
  return disturb.start_nibble == bus::shark::transmit_finished
             ? fmt::format("noise swallows {}", victims)
             : fmt::format("noise swallows byte {} of {}", disturb.byte, victims);
}

std::string Hands::apply(const Babble& babble) {
  world_.wire().babble(world_.now(), babble.span, babble.share);
  const std::string share = babble.share < 1 ? ", " + show(babble.share, Measure::share) + " of the time" : "";
  return fmt::format("somebody babbles on the bus for {}{}", show_time(babble.span), share);
}

std::string Hands::apply(const Jam& jam) {
  world_.wire().jam(world_.now(), jam.span);
  return fmt::format("a transmitter hangs for {}", show_time(jam.span));
}

std::string Hands::apply(const WakePulse& pulse) {
  world_.wire().pulse_wake(world_.now(), pulse.span);
  return fmt::format("SBH is pulled up for {}", show_time(pulse.span));
}

std::string Hands::apply(const Break& broken) {
  world_.chair().set_damage(broken.damage, broken.side, broken.is_broken);
  const char* side = broken.side == Side::left ? "left" : "right";
  const auto tell = [&](const char* part, const char* harm) {
    return broken.is_broken ? fmt::format("the {} {} {}", side, part, harm)
                            : fmt::format("the {} {} is mended", side, part);
  };
  switch (broken.damage) {
    case Damage::open_coil:
      return tell("park brake's wire", "is off");
    case Damage::shorted_coil:
      return tell("park brake's coil", "is shorted");
    case Damage::stuck_bridge:
      return tell("bridge", "is stuck: full voltage, forward");
    case Damage::open_motor:
      return tell("motor's wire", "is off");
    case Damage::blocked_wheel:
      break;
  }
  return fmt::format("the {} wheel {}", side, broken.is_broken ? "stands against a kerb" : "is free again");
}

std::string Hands::apply(const BreakLamp& broken) {
  world_.chair().lamp(broken.place).set_damage(broken.damage, broken.is_broken);
  const char* lamp = broken.place == LampPlace::left_indicator    ? "left indicator"
                     : broken.place == LampPlace::right_indicator ? "right indicator"
                                                                  : "headlight";
  const char* harm = broken.damage == LampDamage::open ? "'s wire is off" : " is shorted";
  return fmt::format("the {}{}", lamp, broken.is_broken ? harm : " is mended");
}

std::string Hands::apply(const BreakActuator& broken) {
  world_.chair().actuator(broken.number).set_damage(broken.damage, broken.is_broken);
  const auto tell = [&](const char* harm) {
    return fmt::format("actuator {}{}", broken.number, broken.is_broken ? harm : " is mended");
  };
  switch (broken.damage) {
    case ActuatorDamage::open:
      return tell("'s wire is off");
    case ActuatorDamage::shorted:
      return tell(" is shorted");
    case ActuatorDamage::blocked:
      return tell(" is blocked");
    case ActuatorDamage::no_end_switch:
      break;
  }
  return tell(" has lost its end switches");
}

std::string Hands::apply(const SpoilMemory& spoiled) {
  const Upset& upset = spoiled.upset;
  world_.board().upset(upset);
  if (upset.memory == Upset::Memory::flash) {
    return fmt::format("bit {} of the flash's byte {} flips", upset.bit, upset.address);
  }
  return fmt::format("bit {} of the RAM's byte {} is stuck {}", upset.bit, upset.address,
                     upset.is_stuck_high ? "high" : "low");
}

std::string Hands::apply(const Slope& slope) {
  world_.chair().set_slope(slope.degrees);
  return fmt::format("the ground is at {}", show(slope.degrees, Measure::angle));
}

std::string Hands::apply(const Dci& dci) {
  world_.ask_for_slow(dci.is_on);
  return dci.is_on ? "the seat asks for slow" : "the seat asks for slow no more";
}

std::string Hands::apply(const Battery& battery) {
  world_.chair().set_battery_voltage(battery.volts);
  return fmt::format("the batteries have {}", show(battery.volts, Measure::voltage));
}

std::string Hands::apply(const Reset& reset) {
  switch (reset) {
    case Reset::watchdog:
      world_.board().reset(ResetKind::watchdog, world_.now());
      return "the watchdog bites";
    case Reset::brown_out:
      world_.board().reset(ResetKind::brown_out, world_.now());
      return "a brown-out resets the chip";
    case Reset::external:
      world_.board().reset(ResetKind::external, world_.now());
      return "somebody resets the chip";
  }
  return "";
}

void Hands::begin_sending(const Send& send) {
  const Time due = sending_ ? sending_->due : world_.now();
  sending_ = Sending{send, due, send.times.value_or(0)};
}

std::optional<Time> Hands::next_due() const {
  return sending_ ? std::optional(sending_->due) : std::nullopt;
}

void Hands::send_if_due() {
  if (!sending_ || world_.now() < sending_->due) {
    return;
  }
  world_.say_as(sending_->what.as, sending_->what.bytes);
  sending_->due += sending_->what.every;
  if (sending_->what.times && --sending_->left == 0) {
    sending_.reset();
  }
}

}  // namespace simulation::scenario
