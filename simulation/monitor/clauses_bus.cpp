// Clauses about the bus: when the power module may speak, and what.
#include "simulation/monitor/clause.hpp"
#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

// A turn that is known for certain and has earned no answer.
bool is_unearned(const Turn& turn) {
  return turn.begun && !turn.is_doubtful && !turn.has_earned_answer();
}

bool answers_corrupt(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return is_unearned(turn) && turn.has_corrupt;
}

bool answers_factory_test(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return is_unearned(turn) && turn.has_factory_test;
}

bool answers_attendant(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return is_unearned(turn) && turn.has_attendant;
}

bool answers_nothing(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return is_unearned(turn) && !turn.has_corrupt && !turn.has_factory_test && !turn.has_attendant;
}

bool tells_general_unasked(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return !turn.is_doubtful && turn.has_power_up && !turn.general;
}

bool speaks_before_power_up(const Scene& scene) {
  const Turn& turn = scene.speech.answered();
  return turn.is_before_power_up && !turn.has_power_up && !turn.is_doubtful;
}

bool is_out_of_range(const Scene& scene) {
  constexpr std::uint8_t type_power_up = 0x5;
  constexpr std::uint8_t type_settings = 0xA;
  constexpr int gauge_full = 18;    // SB-01.1
  constexpr int last_state = 0x0A;  // SB-01.2
  const Packet& packet = *scene.said.packet;
  if (const auto& told = scene.said.general) {
    return told->gauge > gauge_full || told->state > last_state || told->has_stray_bits;
  }
  if (packet.type == type_power_up) {
    return (packet.data[0] & 0x78) != 0;  // SB-05.1
  }
  if (packet.type == type_settings) {  // SB-0A.2
    const int sensitivity = packet.data[0] & 0x0F;
    const int threshold = packet.data[1];
    return (packet.data[0] & 0x40) != 0 || sensitivity < 1 || sensitivity > 10 || threshold < 1 || threshold > 100;
  }
  return false;
}

bool speaks_under_wake(const Scene& scene) {
  return scene.wake_since && scene.said.byte.start - *scene.wake_since > limits::wake_latency;
}

}  // namespace

// clang-format off
std::vector<Clause> bus_clauses() {
  using M = Moment;
  return {
      {"H-05.2", "A turn with corrupt packets and no general is not answered",
       "exact, where nothing collides", "SB-2.13", M::turn, answers_corrupt},
      {"H-09.2", "After a power-up packet no general is sent before one was heard",
       "exact", "SB-3.2, SB-3.4", M::general, tells_general_unasked},
      {"H-28.1", "A factory test is not answered",
       "exact", "SB-07.1", M::turn, answers_factory_test},
      {"H-30.1", "The power module speaks after TF or after 3 ms of silence that ended a turn, and never later",
       "26 us before to 1.6 ms after the end of TF; 2.95 to 4.6 ms after the last character", "SB-2.7, SB-2.12", M::turn,
       [](const Scene& scene) { return scene.speech.is_late_or_early(); }},
      {"H-30.2", "A turn of the attendant control is not answered",
       "exact", "SB-2.8", M::turn, answers_attendant},
      {"H-30.3", "What it says is whole packets with markers and checksums, the general first, TF last",
       "exact; a turn that collides or is cut by wake or reset may break off", "SB-2.3, SB-2.4, SB-2.5, SB-2.7", M::millisecond,
       [](const Scene& scene) { return !scene.speech.flaw().empty(); }},
      {"H-30.4", "Fields it says are in range, unused bits are zero",
       "exact", "SB-5.4, SB-01.1, SB-01.2, SB-05.1, SB-0A.2", M::packet, is_out_of_range},
      {"H-30.5", "It transmits for 10 ms of any 20 ms at most",
       "exact", "SB-2.2", M::character, [](const Scene& scene) { return scene.speech.on_time() > limits::on_time; }},
      {"H-30.6", "It says nothing before a power-up packet",
       "exact", "SB-3.1", M::turn, speaks_before_power_up},
      {"H-30.7", "It says nothing under wake",
       "two characters may still leave: 1.2 ms", "SB-1.3", M::character, speaks_under_wake},
      {"H-30.8", "A turn without a general or a power-up packet is not answered",
       "exact", "SB-2.7, SB-2.13", M::turn, answers_nothing},
  };
}
// clang-format on

}  // namespace simulation::monitor
