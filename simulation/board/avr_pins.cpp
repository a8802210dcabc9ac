#include "simulation/board/avr_pins.hpp"

namespace simulation {
namespace {

// Port bits, in the order of the board's pin table.
constexpr std::uint8_t bit(unsigned number) {
  return static_cast<std::uint8_t>(1U << number);
}
namespace port_b {
constexpr std::uint8_t dci_slowdown = bit(0), status_led = bit(1), wake = bit(2);
constexpr std::uint8_t actuator1_extend = bit(3), actuator1_retract = bit(4), motor_relay = bit(5);
constexpr std::uint8_t actuator2_extend = bit(6), actuator2_retract = bit(7);
}  // namespace port_b
namespace port_c {
constexpr std::uint8_t left_brake = bit(0), right_brake = bit(1);
constexpr std::uint8_t left_indicator = bit(2), right_indicator = bit(3), headlight = bit(4), strap = bit(5);
constexpr std::uint8_t power_latch = bit(6), bridge_enable = bit(7);
}  // namespace port_c
namespace port_d {
constexpr std::uint8_t bus_receive = bit(0), terminal_receive = bit(2);
constexpr std::uint8_t left_forward = bit(6), right_forward = bit(7);
}  // namespace port_d

constexpr int wake_interrupt = 2;
constexpr std::uint8_t wake_pin = 2;
constexpr std::uint16_t full_duty = 511;

avr_ioport_t* find_port(avr_t& avr, char name) {
  return &find_module<avr_ioport_t>(avr, "port", [name](const auto& port) { return port.name == name; });
}

}  // namespace

AvrPins::AvrPins(AvrCore& core)
    : core_(core),
      avr_(core.avr()),
      ports_{find_port(avr_, 'A'), find_port(avr_, 'B'), find_port(avr_, 'C'), find_port(avr_, 'D')},
      timer_(find_module<avr_timer_t>(avr_, "timer", [](const auto& timer) { return timer.name == '1'; })),
      interrupts_(find_module<avr_extint_t>(avr_, "extint", [](const auto&) { return true; })),
      left_{&timer_.comp[AVR_TIMER_COMPA]},
      right_{&timer_.comp[AVR_TIMER_COMPB]} {
  move_wake_to_its_pin();
  calm_level_interrupts();
  simavr_compare_left_ = replace_write<&AvrPins::write_compare>(avr_, left_.unit->r_ocr, *this);
  simavr_compare_right_ = replace_write<&AvrPins::write_compare>(avr_, right_.unit->r_ocr, *this);
  simavr_toggle_[0] = replace_write<&AvrPins::toggle<'A'>>(avr_, port('A').r_pin, *this);
  simavr_toggle_[1] = replace_write<&AvrPins::toggle<'B'>>(avr_, port('B').r_pin, *this);
  simavr_toggle_[2] = replace_write<&AvrPins::toggle<'C'>>(avr_, port('C').r_pin, *this);
  simavr_toggle_[3] = replace_write<&AvrPins::toggle<'D'>>(avr_, port('D').r_pin, *this);
  core.on_reset([this] { reset(); });
}

// simavr believes INT2 to be on PB3; on this chip it is on PB2.
void AvrPins::move_wake_to_its_pin() {
  auto& source = interrupts_.eint[wake_interrupt];
  avr_irq_t* interrupt = &interrupts_.io.irq[wake_interrupt];
  avr_unconnect_irq(avr_io_getirq(&avr_, source.port_ioctl, source.port_pin), interrupt);
  source.port_pin = wake_pin;
  avr_connect_irq(avr_io_getirq(&avr_, source.port_ioctl, source.port_pin), interrupt);
}

// A low level would make simavr ask at every cycle, whatever the interrupt's mode has become.
void AvrPins::calm_level_interrupts() {
  for (auto& source : interrupts_.eint) {
    source.strict_lvl_trig = 0;
  }
}

void AvrPins::reset() {
  left_.value = right_.value = 0;
  calm_level_interrupts();
  for (const char name : {'A', 'B', 'C', 'D'}) {
    for (int i = 0; i < 8; ++i) {
      // The registers have forgotten the levels, the signals have not: let the same level pass again.
      port(name).io.irq[i].flags |= IRQ_FLAG_INIT;
    }
  }
  apply();
}

void AvrPins::drive(const Surroundings& surroundings) {
  surroundings_ = surroundings;
  apply();
}

void AvrPins::apply() {
  // Switches to ground: closed they pull low, open they leave the pin to its pull-up.
  drive_port('B', port_b::wake | (surroundings_.dci_slowdown ? port_b::dci_slowdown : 0),
             surroundings_.wake ? port_b::wake : 0);
  drive_port('C', surroundings_.lighting_fitted ? port_c::strap : 0, 0);
  // Idle lines. The characters themselves go to the UART without passing the pin.
  constexpr std::uint8_t lines = port_d::bus_receive | port_d::terminal_receive;
  drive_port('D', lines, lines);
  auto& wake = interrupts_.eint[wake_interrupt];
  if (avr_regbit_get_array(&avr_, wake.isc, 2) == 0 && !core_.interrupts().is_enabled(wake.vector)) {
    avr_regbit_clear(&avr_, wake.vector.raised);  // a level leaves no flag behind
  }
}

void AvrPins::drive_port(char name, std::uint8_t mask, std::uint8_t levels) {
  avr_ioport_t& port = this->port(name);
  const std::uint8_t inputs_before = port.external.pull_mask;
  port.external.pull_mask = mask;
  port.external.pull_value = levels;
  for (unsigned i = 0; i < 8; ++i) {
    if ((mask & bit(i)) != 0) {
      avr_raise_irq(&port.io.irq[i], levels >> i & 1U);
    } else if ((inputs_before & bit(i)) != 0) {
      avr_raise_irq(&port.io.irq[i], static_cast<unsigned>(avr_.data[port.r_port]) >> i & 1U);  // the pull-up, if on
    }
  }
}

void AvrPins::write_compare(avr_io_addr_t address, std::uint8_t value) {
  const bool is_left = address == left_.unit->r_ocr;
  Compare& compare = is_left ? left_ : right_;
  (is_left ? simavr_compare_left_ : simavr_compare_right_)(avr_, address, value);
  compare.value = static_cast<std::uint16_t>(value | avr_.data[compare.unit->r_ocrh] << 8);
}

template <char name>
void AvrPins::toggle(avr_io_addr_t address, std::uint8_t value) {
  simavr_toggle_[name - 'A'](avr_, address, bits_meant(avr_, value));
}

Pins AvrPins::read() const {
  const auto is_high = [](std::uint8_t levels, std::uint8_t pin) { return (levels & pin) != 0; };
  const std::uint8_t b = driven_high('B');
  const std::uint8_t c = driven_high('C');
  const std::uint8_t d = driven_high('D');
  Pins pins;
  pins.power_latch = is_high(c, port_c::power_latch);
  pins.bridge_enable = is_high(c, port_c::bridge_enable);
  pins.motor_relay = is_high(b, port_b::motor_relay);
  pins.left_forward = is_high(d, port_d::left_forward);
  pins.right_forward = is_high(d, port_d::right_forward);
  pins.left_brake_release = is_high(c, port_c::left_brake);
  pins.right_brake_release = is_high(c, port_c::right_brake);
  pins.left_indicator = is_high(c, port_c::left_indicator);
  pins.right_indicator = is_high(c, port_c::right_indicator);
  pins.headlight = is_high(c, port_c::headlight);
  pins.actuator1_extend = is_high(b, port_b::actuator1_extend);
  pins.actuator1_retract = is_high(b, port_b::actuator1_retract);
  pins.actuator2_extend = is_high(b, port_b::actuator2_extend);
  pins.actuator2_retract = is_high(b, port_b::actuator2_retract);
  pins.status_led = is_high(b, port_b::status_led);
  pins.left_duty = duty(left_);
  pins.right_duty = duty(right_);
  return pins;
}

std::uint8_t AvrPins::driven_high(char name) const {
  const avr_ioport_t& port = this->port(name);
  return avr_.data[port.r_port] & avr_.data[port.r_ddr];
}

std::uint16_t AvrPins::duty(const Compare& compare) const {
  const auto pin = compare.unit->com_pin;
  if ((avr_.data[port('D').r_ddr] >> pin.bit & 1U) == 0) {
    return 0;  // the pull-down
  }
  const std::uint8_t mode = avr_regbit_get_array(&avr_, timer_.wgm, 4);
  const auto kind = timer_.wgm_op[mode].kind;
  const bool is_pwm = kind == avr_timer_wgm_fast_pwm || kind == avr_timer_wgm_fc_pwm;
  const bool is_running = avr_regbit_get_array(&avr_, timer_.cs, 3) != 0;
  const std::uint8_t output = avr_regbit_get(&avr_, compare.unit->com);
  if (!is_pwm || !is_running || output < avr_timer_com_clear) {
    return (driven_high('D') >> pin.bit & 1U) != 0 ? full_duty : 0;
  }
  const unsigned top = (1U << timer_.wgm_op[mode].size) - 1;
  const unsigned high = compare.value < top ? compare.value : top;
  const unsigned share = high * full_duty / top;
  return static_cast<std::uint16_t>(output == avr_timer_com_clear ? share : full_duty - share);
}

}  // namespace simulation
