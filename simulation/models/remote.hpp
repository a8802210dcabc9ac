// The Shark Remote (SR): wakes the SPM, sends its power-up packet until answered, then its general every
// 20 ms, and confirms power-down; carries what its programmer types and what comes back; reports how far a joystick
// calibration has come; answers factory tests, whatever else it does or does not say. It codes and decodes the wire by
// itself (packets.hpp), never with the firmware's codec.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulation/board/spm_board.hpp"
#include "simulation/models/calibration.hpp"
#include "simulation/models/factory_test.hpp"
#include "simulation/models/packets.hpp"
#include "simulation/models/programmer.hpp"
#include "simulation/models/spm_report.hpp"
#include "simulation/models/turn.hpp"
#include "simulation/time.hpp"

namespace simulation {

// What the person at the joystick does, and what the remote reports about itself.
struct RemoteControls {
  int speed = 512;  // raw reading 0 to 1023
  int direction = 512;
  int pot = 255;  // 0 to 255
  bool power_button = false;
  bool horn = false;
  bool lock = false;
  bool hazard = false;
  bool left_indicator = false;
  bool right_indicator = false;
  bool headlight = false;
  bool joystick_error = false;
  bool pot_error = false;
  bool local_fault = false;
  bool non_critical_fault = false;
  bool charger_inhibit = false;
  bool remote_inhibit = false;
  bool calibration_active = false;
  bool calibration_second_pass = false;
  bool hhp_may_send = true;  // flow control of the programmer's tunnel
  int mode = 0;              // requested operating mode
};

struct RemoteIdentity {
  int type = 2;
  int year = 2006;
  int month = 11;
  int serial = 4810;
  int version = 0x25;
  int capabilities = 0x03;
  int power_up_length = 8;  // 6, 7 or 8 data bytes
  int general_length = 7;   // 6 = old remote
};

// The remote's own clock and habits.
struct RemoteTiming : CharacterTiming {
  Time period = 20ms;
  Time wake = 300ms;       // how long the wake is asserted after a press
  Time first_turn = 20ms;  // from the press to the first power-up packet
};

// Of the turns with a general.
struct RemoteStatistics {
  std::uint32_t answers = 0;  // complete: a valid SPM general and its TF before the next turn
  std::uint32_t missed = 0;
  std::uint32_t bad = 0;       // corrupt packets and stray bytes heard, whoever sent them
  std::uint32_t unwanted = 0;  // HHP data packets that came although its last general forbade them
  std::vector<Time> delays;    // of every answer: end of the remote's TF to the answer's first start bit

  Time least_delay() const;  // all three 0 without an answer
  Time median_delay() const;
  Time largest_delay() const;
};

// The world calls act() when next_time() has come, and hear() for every character on the remote's end of the line.
class Remote {
 public:
  using Wake = std::function<void(bool asserted, Time at)>;

  // Both may be set or changed at any time.
  RemoteControls controls;
  RemoteIdentity identity;
  RemoteTiming timing;
  bool is_silent = false;          // runs, but sends nothing by itself; a factory test it answers
  bool is_insistent = false;       // requests lamps and actuators even where one side has none
  bool sends_calibration = false;  // its calibration packet even while calibration is not active
  Programmer programmer;

  void on_transmit(Transmit transmit) { transmit_ = std::move(transmit); }
  void on_wake(Wake wake) { wake_ = std::move(wake); }

  // The press that switches on; without effect while on (a press then is controls.power_button).
  void start(Time now);
  // When act() wants to be called next; Time::max() while off.
  Time next_time() const;
  void act(Time now);
  // Characters sampled before the end of what the remote says itself are its echo and pass unread.
  void hear(const Reception& reception);

  // Until then somebody else says what goes for the remote's own words: it does not answer that.
  void be_spoken_for(Time until) { factory_test_.ignore_until(until); }

  bool is_on() const { return phase_ != Phase::off; }
  bool is_sending_generals() const { return phase_ == Phase::general; }
  bool wake_asserted(Time now) const { return now < wake_until_; }
  bool has_communication_fault() const { return has_communication_fault_; }  // SB-3.5; ends with the next valid general
  bool is_confirming_power_down() const { return is_confirming_; }
  int spm_capabilities() const { return spm_capabilities_; }  // from its power-up packet; 0 until then
  Time turn_began_at() const { return turn_from_; }
  Time turn_ended_at() const { return turn_until_; }  // end of the TF's last stop bit
  const SpmReport& report() const { return report_; }
  const RemoteStatistics& statistics() const { return statistics_; }

  // The packets as they go on the wire, with marker bits and checksum, without TF.
  std::vector<std::uint8_t> power_up_packet() const;
  std::vector<std::uint8_t> general_packet() const;
  std::vector<std::uint8_t> calibration_packet() const;

 private:
  enum class Phase { off, power_up, general };

  void begin_anew(Time now);
  std::vector<std::uint8_t> make_turn();
  void end_wake_if_due(Time now);
  void answer_factory_test(Time now);
  void judge_last_turn(Time now);
  void send_turn(Time now);
  void take_packet(Time at, Time ended);
  void take_general(Time at);
  void take_hhp_data();
  void take_end_of_turn();

  Transmit transmit_;
  Wake wake_;
  Phase phase_ = Phase::off;
  bool is_wake_shown_ = false;
  Time wake_until_{};
  Time next_turn_{};
  Time turn_from_{};
  Time turn_until_{};
  Time says_until_{};                // this turn, or an answer to a factory test
  bool awaits_answer_ = false;       // the last turn was a general without an answer yet
  bool has_general_ = false;         // a valid SPM general since the last turn
  bool allowed_hhp_data_ = false;    // the last general did
  std::optional<Time> answer_from_;  // first start bit after the last turn
  PacketReader reader_;
  FactoryTest factory_test_{FactoryTest::Module::remote};
  Time last_heard_{};
  Calibration calibration_;
  Time spm_heard_{};  // the last valid SPM general, or the first general sent
  bool has_communication_fault_ = false;
  bool is_confirming_ = false;
  int spm_capabilities_ = 0;
  SpmReport report_;
  RemoteStatistics statistics_;
};

}  // namespace simulation
