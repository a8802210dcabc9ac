// bus/shark: frames to packets and packets to bytes.
#include "bus/shark/codec.hpp"
#include "bus/shark/turn.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using namespace bus::shark;

namespace {

Frame frame_of(Type type, const uint8_t (&data)[longest_data], uint8_t length) {
  Frame frame;
  frame.type = static_cast<uint8_t>(type);
  frame.length = length;
  for (uint8_t i = 0; i < length; ++i) {
    frame.data[i] = data[i];
  }
  return frame;
}

// Each byte through all its values in an otherwise empty frame, then noise.
void each_frame(Record& record, Type type, uint8_t least, void (*take)(Record& record, const Frame& frame)) {
  for (uint8_t length = least; length <= longest_data; ++length) {
    for (uint8_t place = 0; place < length; ++place) {
      for (uint8_t value = 0; value <= 0x7F; ++value) {
        uint8_t data[longest_data] = {};
        data[place] = value;
        take(record, frame_of(type, data, length));
      }
    }
  }
  Random random(4);
  for (uint16_t i = 0; i < 1500; ++i) {
    uint8_t data[longest_data];
    for (uint8_t& byte : data) {
      byte = static_cast<uint8_t>(random.one_in(4) ? 0x7F : random.byte() & 0x7F);
    }
    take(record, frame_of(type, data, static_cast<uint8_t>(least + random.below(9U - least))));
  }
}

// Many yes-or-no results as one.
class Flags {
 public:
  Flags& operator<<(bool flag) {
    bits_ = (bits_ << 1) | (flag ? 1U : 0U);
    return *this;
  }
  uint32_t bits() const { return bits_; }

 private:
  uint32_t bits_ = 0;
};

void take_general(Record& record, const Frame& frame) {
  const SrGeneral packet = decode_sr_general(frame);
  record.add(packet.speed.count());
  record.add(packet.direction.count());
  record.add(packet.pot.count());
  record.add(packet.requested_mode);
  Flags flags;
  flags << packet.joystick_error << packet.pot_error << packet.local_fault << packet.charger_inhibit
        << packet.power_switch << packet.horn << packet.lock << packet.hazard_request << packet.left_request
        << packet.right_request << packet.remote_inhibit << packet.hhp_may_send << packet.calibration_active
        << packet.power_down_confirm << packet.has_modes << packet.non_critical_fault << packet.headlight_request;
  record.add(flags.bits());
}

void take_power_up(Record& record, const Frame& frame) {
  const SrPowerUp packet = decode_sr_power_up(frame);
  record.add(packet.remote_type);
  record.add(packet.year);
  record.add(packet.month);
  record.add(packet.serial);
  record.add(packet.version);
  Flags flags;
  flags << packet.has_analog_pot << packet.supports_actuators << packet.supports_lighting;
  record.add(flags.bits());
}

void take_hhp_data(Record& record, const Frame& frame) {
  const HhpData packet = decode_sr_hhp_data(frame);
  record.add(packet.count);
  for (uint8_t i = 0; i < packet.count; ++i) {
    record.add(packet.characters[i]);
  }
}

void take_calibration(Record& record, const Frame& frame) {
  const JoystickCalibration packet = decode_joystick_calibration(frame);
  Flags flags;
  flags << packet.second_pass << packet.neutral_seen << packet.forward_seen << packet.reverse_seen << packet.left_seen
        << packet.right_seen;
  record.add(flags.bits());
}

void take_factory_test(Record& record, const Frame& frame) {
  const FactoryTest packet = decode_factory_test(frame);
  record.add(packet.is_for_sacu);
  record.add(packet.command);
  record.add(packet.address);
  record.add(packet.data);
}

void take_sacu_general(Record& record, const Frame& frame) {
  const SacuGeneral packet = decode_sacu_general(frame);
  record.add(packet.speed.count());
  record.add(packet.direction.count());
  record.add(packet.pot.count());
  record.add(packet.requested_mode);
  Flags flags;
  flags << packet.joystick_error << packet.pot_error << packet.local_fault << packet.calibration_active
        << packet.attendant << packet.non_critical_fault << packet.drive_inhibit;
  record.add(flags.bits());
}

void take_sacu_power_up(Record& record, const Frame& frame) {
  const SacuPowerUp packet = decode_sacu_power_up(frame);
  record.add(packet.year);
  record.add(packet.month);
  record.add(packet.serial);
  record.add(packet.version);
  Flags flags;
  flags << packet.supports_actuator2 << packet.supports_actuator1 << packet.has_speed_control;
  record.add(flags.bits());
}

// As it goes over the wire.
Turn wire_of(const Frame& frame) {
  Turn turn;
  turn.open();
  turn.add(frame);
  return turn;
}

void add_packet(Record& record, const Frame& frame) {
  const Turn turn = wire_of(frame);
  record.add(turn.bytes().size());
  for (const uint8_t byte : turn.bytes()) {
    record.add(byte);
  }
}

SpmGeneral any_general(Random& random) {
  SpmGeneral packet;
  packet.locked = random.coin();
  packet.slowdown = random.coin();
  packet.fuel_gauge = random.byte();
  packet.drive_inhibited = random.coin();
  packet.display_disabled = random.coin();
  packet.power_down_now = random.coin();
  packet.system_state = static_cast<SystemState>(random.below(11));
  packet.lock_mode_enabled = random.coin();
  packet.sr_drive_modified = random.coin();
  packet.joystick_wakes = random.coin();
  packet.sleep_requested = random.coin();
  packet.calibration_mode = random.coin();
  packet.sound_horn = random.coin();
  packet.sacu_drives = random.coin();
  packet.system_driving = random.coin();
  packet.flash_cadence = random.coin();
  packet.hazard_on = random.coin();
  packet.left_on = random.coin();
  packet.right_on = random.coin();
  packet.headlight_on = random.coin();
  packet.sacu_calibration_mode = random.coin();
  packet.sacu_drive_modified = random.coin();
  packet.sacu_acknowledged = random.coin();
  packet.hazard_fault = random.coin();
  packet.left_fault = random.coin();
  packet.right_fault = random.coin();
  packet.headlight_fault = random.coin();
  packet.actuator2_fault = random.coin();
  packet.actuator1_fault = random.coin();
  packet.sr_mode_invalid = random.coin();
  packet.operating_mode = random.byte();
  packet.sacu_mode_invalid = random.coin();
  packet.speedo = random.byte();
  return packet;
}

Admission admission_of(Type type, uint8_t length) {
  Frame frame;
  frame.type = static_cast<uint8_t>(type);
  frame.length = length;
  return admit(frame);
}

}  // namespace

void admissions(Record& record) {
  for (uint16_t type = 0; type <= 255; ++type) {
    for (uint8_t length = 0; length <= 10; ++length) {
      record.add(static_cast<uint8_t>(admission_of(static_cast<Type>(type), length)));
    }
  }

  record.known(static_cast<uint8_t>(admission_of(Type::sr_general, 5)), 2);  // too short
  record.known(static_cast<uint8_t>(admission_of(Type::sr_general, 6)), 0);
  record.known(static_cast<uint8_t>(admission_of(Type::factory_test, 2)), 2);
  record.known(static_cast<uint8_t>(admission_of(Type::factory_test, 3)), 0);
  record.known(static_cast<uint8_t>(admission_of(static_cast<Type>(0x0C), 8)), 1);  // reserved
}

void general_decoding(Record& record) {
  each_frame(record, Type::sr_general, 6, take_general);

  const SrGeneral neutral = decode_sr_general(frame_of(Type::sr_general, {0x40, 0x40, 0x7F, 0x40}, 6));
  record.known(neutral.speed.count(), 512);
  record.known(neutral.direction.count(), 512);
  record.known(neutral.pot.count(), 255);
  record.known(neutral.has_modes, 0);
  const SrGeneral mixed = decode_sr_general(frame_of(Type::sr_general, {0x7F, 0x00, 0x01, 0x3F, 0x02, 0x08, 0x2B}, 7));
  record.known(mixed.speed.count(), 1023);
  record.known(mixed.direction.count(), 7);
  record.known(mixed.pot.count(), 2);
  record.known(mixed.horn, 1);
  record.known(mixed.lock, 0);
  record.known(mixed.remote_inhibit, 1);
  record.known(mixed.non_critical_fault, 1);
  record.known(mixed.requested_mode, 11);
}

void power_up_decoding(Record& record) {
  each_frame(record, Type::sr_power_up, 6, take_power_up);

  const SrPowerUp remote =
      decode_sr_power_up(frame_of(Type::sr_power_up, {0x01, 0x18, 0x0C, 0x7F, 0x7F, 0x7F, 0x25, 0x07}, 8));
  record.known(remote.year, 24);
  record.known(remote.month, 12);
  record.known(static_cast<int32_t>(remote.serial), 2097151);
  record.known(remote.version, 0x25);
  record.known(remote.has_analog_pot, 1);
  record.known(
      static_cast<int32_t>(decode_sr_power_up(frame_of(Type::sr_power_up, {0, 0, 0, 0x05, 0x02, 0x01}, 6)).serial),
      5 * 16384L + 2 * 128 + 1);
}

void hhp_data(Record& record) {
  each_frame(record, Type::sr_hhp_data, 1, take_hhp_data);
  Random random(17);
  for (uint16_t i = 0; i < 500; ++i) {
    HhpData packet;
    packet.count = static_cast<uint8_t>(1 + random.below(8));
    for (uint8_t& character : packet.characters) {
      character = random.byte() & 0x7F;
    }
    add_packet(record, encode(packet));
  }

  const HhpData heard = decode_sr_hhp_data(frame_of(Type::sr_hhp_data, {0x48, 0x69, 0x0D}, 3));
  record.known(heard.count, 3);
  record.known(heard.characters[2], 0x0D);
  HhpData shown;
  shown.characters[0] = 0x41;
  shown.count = 1;
  const Turn packet = wire_of(encode(shown));
  record.known(packet.bytes().size(), 3);
  record.known(packet.bytes()[0], 0x03);
  record.known(packet.bytes()[1], 0xC1);
  record.known(packet.bytes()[2], 0xBB);  // 03 + C1 = C4, of which 44 counts
}

void calibration_and_factory_test(Record& record) {
  each_frame(record, Type::joystick_calibration, 1, take_calibration);
  each_frame(record, Type::factory_test, 3, take_factory_test);

  const JoystickCalibration progress = decode_joystick_calibration(frame_of(Type::joystick_calibration, {0x28}, 1));
  record.known(progress.second_pass, 1);
  record.known(progress.neutral_seen, 0);
  record.known(progress.forward_seen, 1);
  const FactoryTest test = decode_factory_test(frame_of(Type::factory_test, {0x73, 0x43, 0x25}, 3));
  record.known(test.is_for_sacu, 1);
  record.known(test.command, 3);
  record.known(test.address, 0xC3);
  record.known(test.data, 0xA5);
}

void sacu_decoding(Record& record) {
  each_frame(record, Type::sacu_general, 6, take_sacu_general);
  each_frame(record, Type::sacu_power_up, 7, take_sacu_power_up);

  const SacuGeneral general =
      decode_sacu_general(frame_of(Type::sacu_general, {0x40, 0x40, 0x7F, 0x40, 0x04, 0x03}, 6));
  record.known(general.speed.count(), 512);
  record.known(general.pot.count(), 255);
  record.known(general.attendant, 1);
  record.known(general.drive_inhibit, 0);
  record.known(general.requested_mode, 3);
  const SacuPowerUp power_up =
      decode_sacu_power_up(frame_of(Type::sacu_power_up, {0x0A, 0x09, 0x5E, 0x2D, 0x45, 0x25, 0x02}, 7));
  record.known(power_up.month, 9);
  record.known(static_cast<int32_t>(power_up.serial), 1545925);  // 94 * 16384 + 45 * 128 + 69
  record.known(power_up.supports_actuator1, 1);
  record.known(power_up.has_speed_control, 0);
}

void general_encoding(Record& record) {
  Random random(5);
  for (uint16_t i = 0; i < 1500; ++i) {
    add_packet(record, encode(any_general(random)));
  }

  SpmGeneral general;
  const Turn empty = wire_of(encode(general));
  record.known(empty.bytes().size(), 9);
  record.known(empty.bytes()[0], 0x61);
  record.known(empty.bytes()[1], 0x80);
  record.known(empty.bytes()[8], 0x9E);  // 7F - 61, and the marker
  general.fuel_gauge = 18;
  general.speedo = 31;
  const Turn fast = wire_of(encode(general));
  record.known(fast.bytes()[1], 0x92);
  record.known(fast.bytes()[7], 0x9F);
  record.known(fast.bytes()[8], 0xED);  // 61 + 12 + 1F = 92, of which 12 counts
}

void other_encodings(Record& record) {
  for (uint8_t bits = 0; bits < 8; ++bits) {
    SpmPowerUp packet;
    packet.supports_actuator2 = (bits & 4) != 0;
    packet.supports_actuator1 = (bits & 2) != 0;
    packet.supports_lighting = (bits & 1) != 0;
    add_packet(record, encode(packet));
  }
  for (uint16_t value = 0; value <= 255; ++value) {
    SpmSettings packet;
    packet.speedo_option = (value & 1) != 0;
    packet.click_on_keypress = (value & 2) != 0;
    packet.speed_button_sensitivity = static_cast<uint8_t>(value);
    packet.joystick_switch_threshold = static_cast<uint8_t>(255 - value);
    add_packet(record, encode(packet));
  }

  const Turn power_up = wire_of(encode(SpmPowerUp()));
  record.known(power_up.bytes()[0], 0x05);
  record.known(power_up.bytes()[1], 0x80);
  record.known(power_up.bytes()[2], 0xFA);
  const Turn settings = wire_of(encode(SpmSettings()));
  record.known(settings.bytes()[0], 0x1A);
  record.known(settings.bytes()[1], 0x85);
  record.known(settings.bytes()[2], 0xA7);
  record.known(settings.bytes()[3], 0xB9);  // 1A + 05 + 27 = 46
}

}  // namespace vectors
