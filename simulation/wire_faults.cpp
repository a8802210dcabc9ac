#include "simulation/wire_faults.hpp"

#include <algorithm>

#include "bus/shark/frame.hpp"

namespace simulation {
namespace {

// Start byte, data and checksum; TF stands alone.
int packet_size(std::uint8_t start) {
  return start == bus::shark::transmit_finished ? 1 : bus::shark::length_of(start) + 2;
}

// No sender pauses that long within a turn.
constexpr Time between_turns = 5ms;

}  // namespace

void WireFaults::pass(Character& character) {
  keep_late(character);
  Packet& packet = packets_[static_cast<std::size_t>(character.sender)];
  ++packet.place;
  if (!bus::shark::has_marker(character.sent)) {
    packet = {0, packet_size(character.sent), take(character)};
  }
  if (!packet.fate || packet.place >= packet.size) {
    return;
  }
  const Disturbance& fate = *packet.fate;
  switch (fate.way) {
    case Disturbance::Way::corrupt_checksum:
      if (packet.place > 0 && packet.place == packet.size - 1) {
        character.value ^= 0x01;
      }
      break;
    case Disturbance::Way::flip_bit:
      if (packet.place == fate.byte) {
        character.value ^= static_cast<std::uint8_t>(1U << fate.bit);
      }
      break;
    case Disturbance::Way::drop:
      character.is_dropped = packet.place == fate.byte;
      break;
    case Disturbance::Way::framing_error:
      character.has_broken_stop_bit = packet.place == fate.byte;
      break;
    case Disturbance::Way::late_byte:
      if (packet.place == fate.byte) {
        turns_[static_cast<std::size_t>(character.sender)].late += fate.by;
        character.start += fate.by;
      }
      break;
  }
}

void WireFaults::keep_late(Character& character) {
  Turn& turn = turns_[static_cast<std::size_t>(character.sender)];
  if (character.start - turn.planned > between_turns) {
    turn.late = {};
  }
  turn.planned = character.start;
  character.start += turn.late;
}

std::optional<Disturbance> WireFaults::take(const Character& start) {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(), [&](const Disturbance& disturbance) {
    return disturbance.sender == start.sender && disturbance.type == bus::shark::type_of(start.sent);
  });
  if (found == waiting_.end()) {
    return std::nullopt;
  }
  const Disturbance taken = *found;
  if (--found->count <= 0) {
    waiting_.erase(found);
  }
  return taken;
}

}  // namespace simulation
