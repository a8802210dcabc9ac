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
// Neutral, and the bit.
constexpr const char* button_at_rest = "60 C0 C0 FF C0 84 84 80 D8 0F";
constexpr const char* confirm = "60 C0 C0 FF C0 80 85 80 DB 0F";
constexpr const char* inhibit_at_rest = "60 C0 C0 FF C0 80 8C 80 D4 0F";
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
}  // namespace spm

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
  void cycles(int count, const std::string& bytes, const std::string& answer);
  // From now on the duties go there, by so many steps a millisecond. Forward positive.
  void drive(int left, int right, int step = 1);
  void jump(int left, int right);
  void currents(double left, double right) { left_current_ = left, right_current_ = right; }
  void brakes(bool are_released);  // with bridge and relay
  // Just before the sample so long from now.
  void later(Time span, std::function<void()> deed) { deeds_.emplace_back(now + span, std::move(deed)); }

  // ---- situations
  void greet();                                   // powered, latched, power-up packets exchanged; 30 ms
  void wake_up();                                 // and neutral seen; the last answer tells so
  void set_off(const char* bytes = sr::forward);  // and brakes released for 120 ms
  void drive_at(int duty);                        // and both wheels with that duty, for 20 ms at least

  Time now{};
  Pins pins;

  // ---- the verdict
  bool breaks(const std::string& clause) const;
  std::string breaches() const;  // all ids; none: an empty text

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
