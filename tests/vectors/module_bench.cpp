#include "tests/vectors/module_bench.hpp"

namespace vectors {

using namespace base;        // literals
using namespace bus::shark;  // names of the wire

namespace {

constexpr uint16_t character = 286;  // microseconds

uint32_t switched(const spm::Outputs& out) {
  return (out.bridge_enabled ? 1U : 0U) | (out.relay_closed ? 2U : 0U) |
         (out.left_brake == spm::Brake::released ? 4U : 0U) | (out.right_brake == spm::Brake::released ? 8U : 0U) |
         (out.status_led ? 16U : 0U) | (out.are_motors_as_before ? 32U : 0U) | (static_cast<uint32_t>(out.latch) << 8) |
         (static_cast<uint32_t>(out.speech) << 10);
}

}  // namespace

ModuleBench::ModuleBench(Record& record, const spm::Settings& settings) : record_(record), spm_(settings) {
  in_.battery = 25000_mV;
  in_.analog_ready = true;
}

void ModuleBench::wait(uint16_t halves) {
  for (uint16_t i = 0; i < halves; ++i) {
    pass(500);
    step();
  }
}

void ModuleBench::stand_still(uint32_t milliseconds) {
  now_ = now_ + Millis(milliseconds);
  in_.stamp = in_.stamp + Micros(static_cast<uint16_t>(milliseconds * 1000U));
  step();
}

void ModuleBench::power_up() {
  const uint8_t data[] = {0x01, 0x18, 0x0C, 0x05, 0x02, 0x01, 0x25, 0x00};
  say(Type::sr_power_up, data, 8, 0);
  wait(33);
}

void ModuleBench::generals(const General& general, uint8_t count) {
  const uint8_t data[] = {general.speed, general.direction, 0x7F, 0x40, general.switches, general.answers, 0x00};
  for (uint8_t i = 0; i < count; ++i) {
    say(Type::sr_general, data, 7, general.spoiled);
    wait(33);
  }
}

void ModuleBench::say(Type type, const uint8_t* data, uint8_t length, uint8_t spoiled) {
  uint8_t sum = start_byte(type, length);
  hear(sum, false);
  for (uint8_t i = 0; i < length; ++i) {
    const uint8_t byte = static_cast<uint8_t>(data[i] | 0x80);
    sum = static_cast<uint8_t>(sum + byte);
    hear(byte, false);
  }
  hear(static_cast<uint8_t>((0xFF - (sum & 0x7F)) ^ spoiled), false);
  hear(0x0F, false);
}

void ModuleBench::hear(uint8_t byte, bool is_spoiled) {
  pass(character);
  if (byte == 0x0F && !is_spoiled && in_.speaker == spm::Speaker::armed) {
    in_.speaker = spm::Speaker::speaking;
    until_said_ = 4000;
  }
  in_.heard[0] = HeardByte{byte, is_spoiled, in_.stamp};
  in_.heard_count = 1;
  step();
  in_.heard_count = 0;
}

void ModuleBench::pass(uint16_t microseconds) {
  in_.stamp = in_.stamp + Micros(microseconds);
  since_tick_ = static_cast<uint16_t>(since_tick_ + microseconds);
  if (since_tick_ >= 1000) {
    since_tick_ = static_cast<uint16_t>(since_tick_ - 1000);
    now_ = now_ + 1_ms;
  }
  until_said_ = static_cast<uint16_t>(until_said_ > microseconds ? until_said_ - microseconds : 0);
  if (until_said_ == 0 && in_.speaker == spm::Speaker::speaking) {
    in_.speaker = spm::Speaker::idle;
  }
}

void ModuleBench::step() {
  const uint16_t coils = static_cast<uint16_t>((out_.left_brake == spm::Brake::released ? 650U : 0U) +
                                               (out_.right_brake == spm::Brake::released ? 650U : 0U));
  in_.brake_coils = Milliamps(coils);
  out_ = spm_.step(in_, now_);
  if (out_.speech == spm::Speech::arm && in_.speaker == spm::Speaker::idle) {
    in_.speaker = spm::Speaker::armed;
  }
  add_outputs();
}

// Field by field: the struct has padding on the host, and its turn is a pointer.
void ModuleBench::add_outputs() {
  record_.add((static_cast<uint32_t>(static_cast<uint16_t>(out_.left.count())) << 16) |
              static_cast<uint16_t>(out_.right.count()));
  record_.add(switched(out_));
  if (out_.speech == spm::Speech::arm || out_.speech == spm::Speech::speak) {
    for (uint8_t i = 0; i < out_.turn.size(); ++i) {
      said_[i] = out_.turn[i];
      record_.add(said_[i]);
    }
  }
  record_.add((static_cast<uint32_t>(spm_.inhibits().bits()) << 16) | spm_.active_faults().bits());
}

}  // namespace vectors
