// Traces made by hand, for the monitor to judge: characters as literals, pins as they are set. Every millisecond a
// sample is taken; the duties go to their goals by the steps a test gives them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "simulation/monitor/monitor.hpp"

namespace stage {

using namespace simulation;

// Whole turns. The checksums are worked out by hand from the document.
namespace sr {
constexpr const char* power_up = "74 82 86 8B 80 A5 CA A5 83 E1 0F";
constexpr const char* neutral = "60 C0 C0 FF C0 80 84 80 DC 0F";
constexpr const char* edge_of_neutral = "60 C3 BC FF F2 80 84 80 AB 0F";  // 542, 482
constexpr const char* beyond_neutral = "60 C3 C0 FF F8 80 84 80 A1 0F";   // 543, 512
constexpr const char* forward = "60 F3 C0 FF C8 80 84 80 A1 0F";          // 921, 512
constexpr const char* backward = "60 8C C0 FF F8 80 84 80 D8 0F";         // 103, 512
constexpr const char* right = "60 C0 F3 FF C1 80 84 80 A8 0F";            // 512, 921
constexpr const char* corrupt = "60 F3 C0 FF C8 80 84 80 A0 0F";
// Forward, and the bit.
constexpr const char* remote_inhibit = "60 F3 C0 FF C8 80 8C 80 99 0F";
constexpr const char* charger_inhibit = "60 F3 C0 FF C8 88 84 80 99 0F";
constexpr const char* joystick_error = "60 F3 C0 FF C8 C0 84 80 E1 0F";
constexpr const char* local_fault = "60 F3 C0 FF C8 90 84 80 91 0F";
constexpr const char* pot_error = "60 F3 C0 FF C8 A0 84 80 81 0F";
constexpr const char* non_critical = "60 F3 C0 FF C8 80 84 A0 81 0F";
constexpr const char* calibration = "60 F3 C0 FF C8 80 86 80 9F 0F";
constexpr const char* button = "60 F3 C0 FF C8 84 84 80 9D 0F";
constexpr const char* mode_1 = "60 F3 C0 FF C8 80 84 81 A0 0F";
constexpr const char* mode_4 = "60 F3 C0 FF C8 80 84 84 9D 0F";
constexpr const char* mode_1_back = "60 8C C0 FF F8 80 84 81 D7 0F";
constexpr const char* mode_2 = "60 F3 C0 FF C8 80 84 82 9F 0F";
constexpr const char* mode_3 = "60 F3 C0 FF C8 80 84 83 9E 0F";
constexpr const char* inhibited_mode_1 = "60 F3 C0 FF C8 80 8C 81 98 0F";
// Neutral, and the bit.
constexpr const char* mode_1_at_rest = "60 C0 C0 FF C0 80 84 81 DB 0F";
constexpr const char* mode_2_at_rest = "60 C0 C0 FF C0 80 84 82 DA 0F";
constexpr const char* mode_3_at_rest = "60 C0 C0 FF C0 80 84 83 D9 0F";
constexpr const char* left = "60 C0 C0 FF C0 80 A4 80 BC 0F";
constexpr const char* right_side = "60 C0 C0 FF C0 80 94 80 CC 0F";
constexpr const char* hazard = "60 C0 C0 FF C0 80 C4 80 9C 0F";
constexpr const char* headlight = "60 C0 C0 FF C0 80 84 90 CC 0F";
constexpr const char* button_at_rest = "60 C0 C0 FF C0 84 84 80 D8 0F";
constexpr const char* confirm = "60 C0 C0 FF C0 80 85 80 DB 0F";
constexpr const char* inhibit_at_rest = "60 C0 C0 FF C0 80 8C 80 D4 0F";
constexpr const char* power_up_plain = "74 82 86 8B 80 A5 CA A5 80 E4 0F";  // no capability
constexpr const char* power_up_short = "54 82 86 8B 80 A5 CA A9 0F";        // six data bytes
// Six data bytes.
constexpr const char* old_neutral = "50 C0 C0 FF C0 80 84 EC 0F";
constexpr const char* old_forward = "50 F3 C0 FF C8 80 84 B1 0F";
}  // namespace sr

namespace spm {
constexpr const char* nothing = "";
constexpr const char* power_up = "05 80 FA 0F";
constexpr const char* ready = "61 92 80 C0 80 80 80 80 CC 0F";
constexpr const char* driving = "61 92 80 C0 A0 80 80 80 AC 0F";
constexpr const char* inhibited = "61 92 C0 C0 80 80 80 80 8C 0F";
constexpr const char* awaiting_neutral = "61 92 C0 E0 80 80 80 80 EC 0F";  // and inhibited, here and below
constexpr const char* limping = "61 B2 89 C0 A0 80 80 80 83 0F";           // state 09
constexpr const char* limping_at_rest = "61 B2 C9 E0 80 80 80 80 C3 0F";
constexpr const char* limping_for_remote = "61 B2 87 C0 A0 80 80 80 85 0F";  // state 07
constexpr const char* power_down_now = "61 92 D0 C0 80 80 80 80 FC 0F";
constexpr const char* sleep = "61 92 D0 C8 80 80 80 80 F4 0F";
constexpr const char* mode_1_invalid = "61 92 C0 E0 80 80 91 80 DB 0F";
constexpr const char* mode_1 = "61 92 C0 E0 80 80 81 80 EB 0F";
constexpr const char* mode_4_invalid = "61 92 C0 E0 80 80 94 80 D8 0F";
constexpr const char* mode_4 = "61 92 C0 E0 80 80 84 80 E8 0F";
constexpr const char* power_up_all = "05 87 F3 0F";
constexpr const char* power_up_1 = "05 82 F8 0F";
constexpr const char* power_up_2 = "05 84 F6 0F";
constexpr const char* mode_1_valid = "61 92 80 C0 80 80 81 80 CB 0F";
constexpr const char* mode_1_moving = "61 92 80 C0 A0 80 81 80 AB 0F";
constexpr const char* mode_2_valid = "61 92 80 C0 80 80 82 80 CA 0F";
constexpr const char* mode_3_valid = "61 92 80 C0 80 80 83 80 C9 0F";
constexpr const char* mode_1_misplaced = "61 92 C0 E0 80 80 81 A0 CB 0F";
constexpr const char* mode_1_moving_inhibited = "61 92 C0 E0 A0 80 81 80 CB 0F";
// Who drives.
constexpr const char* acknowledging = "61 92 80 C0 80 90 80 80 BC 0F";
constexpr const char* attendant = "61 92 80 C0 C0 80 80 80 8C 0F";
constexpr const char* attendant_driving = "61 92 80 C0 E0 80 80 80 EC 0F";
constexpr const char* attendant_inhibited = "61 92 C0 C0 C0 80 80 80 CC 0F";
constexpr const char* attendant_awaiting = "61 92 C0 C0 C0 A0 80 80 AC 0F";
constexpr const char* attendant_awaiting_wrong = "61 92 C0 E0 C0 80 80 80 AC 0F";
constexpr const char* awaiting_attendant_wrong = "61 92 C0 C0 80 A0 80 80 EC 0F";
constexpr const char* attendant_limping = "61 B2 C9 C0 C0 A0 80 80 83 0F";
constexpr const char* attendant_limping_acknowledging = "61 B2 C9 C0 C0 B0 80 80 F3 0F";
constexpr const char* attendant_limping_driving = "61 B2 89 C0 E0 80 80 80 C3 0F";
constexpr const char* attendant_mode_1 = "61 92 80 C0 C0 80 81 80 8B 0F";
constexpr const char* attendant_mode_1_invalid = "61 92 C0 C0 C0 80 81 A0 AB 0F";
constexpr const char* attendant_mode_1_misplaced = "61 92 C0 C0 C0 80 91 80 BB 0F";
// Lock and calibration, with nothing else.
constexpr const char* locked_only = "61 D2 80 C0 80 80 80 80 8C 0F";
constexpr const char* calibrating = "61 92 80 C4 80 80 80 80 C8 0F";
constexpr const char* calibrating_attendant = "61 92 80 C0 80 C0 80 80 8C 0F";
constexpr const char* locked_down = "61 D2 D0 C0 80 80 80 80 BC 0F";
// Lamps: status and cadence.
constexpr const char* left = "61 92 80 C0 94 80 80 80 B8 0F";
constexpr const char* left_dark = "61 92 80 C0 84 80 80 80 C8 0F";
constexpr const char* left_fault = "61 92 80 C0 94 84 80 80 B4 0F";
constexpr const char* hazard = "61 92 80 C0 98 80 80 80 B4 0F";
constexpr const char* hazard_and_left = "61 92 80 C0 9C 80 80 80 B0 0F";
constexpr const char* headlight = "61 92 80 C0 81 80 80 80 CB 0F";
constexpr const char* cadence = "61 92 80 C0 90 80 80 80 BC 0F";
constexpr const char* right = "61 92 80 C0 92 80 80 80 BA 0F";
// Slowdown.
constexpr const char* dci = "61 B2 80 C0 80 80 80 80 AC 0F";
constexpr const char* user_slow = "61 B2 81 C0 80 80 80 80 AB 0F";
constexpr const char* limping_still = "61 B2 89 C0 80 80 80 80 A3 0F";
}  // namespace spm

// The attendant control's turns: power-up (actuator 1, no speed control), and generals.
namespace sacu {
constexpr const char* power_up = "69 8A 89 DE AD C5 A5 82 8C 0F";
constexpr const char* power_up_all = "69 8A 89 DE AD C5 A5 87 87 0F";
// Switched off, and the bit.
constexpr const char* standing_by = "58 C0 C0 FF C0 80 80 E8 0F";
constexpr const char* standing_by_forward = "58 F3 C0 FF C8 80 80 AD 0F";
constexpr const char* inhibit = "58 C0 C0 FF C0 81 80 E7 0F";
constexpr const char* local_fault = "58 C0 C0 FF C0 90 80 D8 0F";
constexpr const char* calibration = "58 C0 C0 FF C0 88 80 E0 0F";
constexpr const char* non_critical = "58 C0 C0 FF C0 82 80 E6 0F";
// It drives.
constexpr const char* neutral = "58 C0 C0 FF C0 84 80 E4 0F";
constexpr const char* forward = "58 F3 C0 FF C8 84 80 A9 0F";
constexpr const char* backward = "58 8C C0 FF F8 84 80 E0 0F";
constexpr const char* joystick_error = "58 F3 C0 FF C8 C4 80 E9 0F";
constexpr const char* pot_error = "58 F3 C0 FF C8 A4 80 89 0F";
constexpr const char* mode_1 = "58 F3 C0 FF C8 84 81 A8 0F";
constexpr const char* mode_1_at_rest = "58 C0 C0 FF C0 84 81 E3 0F";
constexpr const char* mode_2_at_rest = "58 C0 C0 FF C0 84 82 E2 0F";
}  // namespace sacu

class Stage {
 public:
  Stage();

  // ---- the trace
  void power(bool is_on);
  void wake(bool is_on);
  void reset();
  void run(Time span) { run_until(now + span); }
  void run_until(Time end);
  // Characters back to back from now on.
  void says(Sender sender, const std::string& bytes, Time character = 286us);
  // The remote's turn and, 44 us later, the answer.
  void turn(const std::string& bytes, const std::string& answer);
  // The same, and then what is left of 20 ms.
  void cycle(const std::string& bytes, const std::string& answer);
  // And with the attendant control's turn 100 us after the power module's; its general ends 8.152 ms after the begin.
  void trio(const std::string& remote, const std::string& answer, const std::string& attendant);
  void trios(int count, const std::string& remote, const std::string& answer, const std::string& attendant);
  void cycles(int count, const std::string& bytes, const std::string& answer);
  // From now on the duties go there, by so many steps a millisecond. Forward positive.
  void drive(int left, int right, int step = 1);
  void jump(int left, int right);
  void currents(double left, double right) { left_current_ = left, right_current_ = right; }
  void brakes(bool are_released);  // with bridge and relay
  // Just before the sample so long from now.
  void later(Time span, std::function<void()> deed) { deeds_.emplace_back(now + span, std::move(deed)); }

  // ---- situations
  // Powered, latched, power-up packets exchanged; 30 ms.
  void greet(const char* answer = spm::power_up, const char* remote = sr::power_up);
  void wake_up(const char* answer = spm::power_up);            // and neutral seen; the last answer tells so
  void meet_attendant(const char* power_up = sacu::power_up);  // and it is acknowledged and stands by
  void hand_over();                                            // and drives: five neutrals, told
  void attend_at_100();                                        // both wheels, its stick forward
  void set_off(const char* bytes = sr::forward);               // and brakes released for 120 ms
  void drive_at(int duty);                                     // and both wheels with that duty, for 20 ms at least

  Time now{};
  Pins pins;

  // ---- the verdict
  bool breaks(const std::string& clause) const;
  // All ids; none: an empty text. H-17.9 is left out: most traces answer with whatever general is at hand, driving or
  // not.
  std::string breaches() const;

 private:
  void sample();

  std::unique_ptr<monitor::Monitor> monitor_;
  Time sampled_{};
  bool is_powered_ = false;
  std::uint32_t resets_ = 0;
  std::vector<std::pair<Time, std::function<void()>>> deeds_;
  int left_ = 0;
  int right_ = 0;
  int left_goal_ = 0;
  int right_goal_ = 0;
  int step_ = 1;
  double left_current_ = 0;  // A
  double right_current_ = 0;
};

}  // namespace stage
