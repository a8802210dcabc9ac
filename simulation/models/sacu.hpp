// The attendant control (SACU): a second joystick that speaks after the power module. It sends its power-up packet
// once a cycle, for as long as it takes, until a general of the power module acknowledges it; then its general once a
// cycle. A power-up packet of the power module makes it begin anew: the module has started again and knows nothing of
// it. (The document says neither how long a SACU repeats its power-up packet nor when it begins again. So it does what
// an SR does.) A factory test it answers in its own time, whatever else it does or does not say.
//
// It codes and decodes the wire by itself (packets.hpp). What its controls say goes on the wire as it is: a joystick
// error does not put the stick in neutral, a missing capability does not take the pot to zero. A SACU that keeps the
// document's rules (5/08) is a matter of setting the controls so; one that does not is the harder test.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/models/calibration.hpp"
#include "simulation/models/factory_test.hpp"
#include "simulation/models/packets.hpp"
#include "simulation/models/spm_report.hpp"
#include "simulation/models/turn.hpp"
#include "simulation/time.hpp"

namespace simulation {

struct SacuControls {
  int speed = 512;  // raw reading 0 to 1023
  int direction = 512;
  int pot = 255;                // 0 to 255
  bool is_attendant = false;    // the switch: attendant or user
  bool joystick_error = false;  // SB-08.1
  bool pot_error = false;
  bool local_fault = false;
  bool non_critical_fault = false;
  bool calibration_active = false;
  bool calibration_second_pass = false;
  bool drive_inhibit = false;
  int mode = 0;  // requested operating mode
};

// As a real one was heard to say (SB-09.1).
struct SacuIdentity {
  int year = 2010;
  int month = 9;
  int serial = 1545925;
  int version = 0x25;
  int capabilities = 0x02;  // 2 actuator 2, 1 actuator 1, 0 speed control
};

struct SacuTiming : CharacterTiming {
  Time pause = 100us;    // from the end of the TF to its own turn
  bool is_rash = false;  // follows the remote's TF instead of the power module's: two speak at once
};

// The world calls act() when next_time() has come, and hear() for every character at its end of the line.
class Sacu {
 public:
  // All may be set or changed at any time.
  SacuControls controls;
  SacuIdentity identity;
  SacuTiming timing;
  bool is_silent = false;          // hears, but sends nothing by itself; a factory test it answers
  bool insists = false;            // sends generals whether acknowledged or not
  bool sends_calibration = false;  // its calibration packet even while calibration is not active

  void on_transmit(Transmit transmit) { transmit_ = std::move(transmit); }

  // Plugged in, it knows nothing of what was before.
  void attach();
  void detach() { is_attached_ = false; }
  bool is_attached() const { return is_attached_; }

  // When act() wants to be called next; Time::max() while it waits for somebody's turn to end.
  Time next_time() const;
  void act(Time now);
  // Characters sampled before the end of its own turn are its echo and pass unread.
  void hear(const Reception& reception);

  // Until then somebody else says what goes for its own words: it does not answer that.
  void be_spoken_for(Time until) { factory_test_.ignore_until(until); }

  bool is_acknowledged() const { return is_acknowledged_; }
  Time turn_ended_at() const { return turn_until_; }  // end of the TF's last stop bit
  const SpmReport& report() const { return report_; }
  std::uint32_t bad() const { return reader_.bad(); }  // corrupt packets and stray bytes heard, whoever sent them

  // The packets as they go on the wire, with marker bits and checksum, without TF.
  std::vector<std::uint8_t> power_up_packet() const;
  std::vector<std::uint8_t> general_packet() const;
  std::vector<std::uint8_t> calibration_packet() const;

 private:
  static constexpr Time never = Time::max();
  enum class Speaker { nobody, remote, power_module };

  std::vector<std::uint8_t> make_turn();
  void begin_anew();
  void send_turn(Time now);
  void answer_factory_test(Time now);
  void take_packet(Time at, Time ended);
  void take_end_of_turn(Time ended);

  Transmit transmit_;
  bool is_attached_ = false;
  PacketReader reader_;
  FactoryTest factory_test_{FactoryTest::Module::attendant_control};
  Speaker speaker_ = Speaker::nobody;  // of the latest valid packet of this turn
  Time turn_due_ = never;              // a TF has given it the line
  Time silence_due_ = never;           // or silence will (SB-2.12)
  Time turn_until_{};
  bool has_introduced_itself_ = false;
  bool is_acknowledged_ = false;
  SpmReport report_;
  Calibration calibration_;
};

}  // namespace simulation
