// What an observer of the chair knows at this moment; the conditions of a scenario are asked of this.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/report/packet.hpp"
#include "simulation/world.hpp"

namespace simulation::report {

// The moment from which "since" counts: the begin of the step that asks.
struct Anchor {
  Time at{};
  double position = 0;  // m along the way
  std::uint32_t resets = 0;
};

class Facts : public Observer {
 public:
  // The world must outlive the facts.
  explicit Facts(World& world);

  void on_byte(const BusByte& byte) override;
  void on_sample(const Sample& sample) override;

  Anchor anchor() const;

  const Pins& pins() const { return sample_.pins; }
  const ChairState& chair() const { return sample_.chair; }
  bool is_powered() const;
  std::uint32_t resets() const;

  bool is_driven() const;       // some motor has a duty and its bridge is alive
  bool has_sped_up() const;     // a duty grew, or turned round, since the sample before
  double largest_duty() const;  // 0 to 1
  double position() const;      // m, forward positive, along the way
  double speed() const;         // m/s, forward positive
  double turn_rate() const;     // degrees a second, to the right positive
  double left_wheel() const;    // m/s at the tread, forward positive
  double right_wheel() const;
  double left_duty() const;  // -1 to 1, forward positive; 0 while the bridge is dead
  double right_duty() const;
  bool is_cable_cut() const;
  bool shows_communication_fault() const;        // the remote does (SB-3.5)
  const std::string& programmer_screen() const;  // what the programmer behind the remote shows
  std::vector<std::uint8_t> eeprom() const;      // of the power module, as it is now

  // The SPM's last valid general packet, marker bits stripped.
  const std::optional<std::vector<std::uint8_t>>& spm_general() const { return spm_general_; }
  bool was_answered() const { return was_answered_; }  // the SR's last complete turn
  // From the end of the SR's turn to the SPM's start bit, of the last answer; negative: spoke into the turn.
  std::optional<Time> answer_delay() const { return answer_delay_; }
  std::optional<Time> answer_began_at() const { return answer_began_at_; }
  std::optional<Time> spoke_at() const { return spoke_at_; }  // start of the SPM's last byte
  std::optional<Time> last_byte_of(Sender sender) const { return last_byte_of_[static_cast<std::size_t>(sender)]; }
  std::optional<Time> sr_turn_began_at() const { return sr_from_; }
  Time last_byte_ended_at() const { return last_byte_ended_at_; }
  // Whole packets, oldest first.
  const std::vector<Packet>& packets_of(Sender sender) const { return packets_[static_cast<std::size_t>(sender)]; }

 private:
  void hear_spm(const BusByte& byte);
  void take(const Packet& packet);

  World& world_;
  Listener listener_;
  Sample sample_;
  Sample before_;
  std::optional<std::vector<std::uint8_t>> spm_general_;
  std::array<std::vector<Packet>, sender_count> packets_;
  std::array<std::optional<Time>, sender_count> last_byte_of_;  // its start
  std::optional<Time> sr_from_;                                 // start of the SR's turn
  std::optional<Time> sr_until_;                                // end of its last byte so far
  std::optional<Time> spoke_at_;
  std::optional<Time> answer_delay_;
  std::optional<Time> answer_began_at_;
  bool was_answered_ = false;
  Time last_byte_ended_at_{};
};

}  // namespace simulation::report
