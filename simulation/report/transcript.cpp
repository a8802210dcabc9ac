#include "simulation/report/transcript.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/report/decode.hpp"
#include "simulation/report/packet.hpp"

namespace simulation::report {
namespace {

// Longer than any gap inside a turn (real remotes leave up to 1.3 ms), shorter than a cycle of 20 ms.
constexpr Time cycle_pause = 5ms;

bool is_same(const BusByte& one, const BusByte& other) {
  return one.sender == other.sender && one.sent == other.sent;
}

// One line a packet, with its bytes.
std::string tell(const Transcript::Cycle& cycle) {
  std::string text;
  Listener listener([&](const Packet& packet) {
    const Decoded decoded = decode(packet);
    const std::string said = packet.kind == Packet::Kind::packet ? describe(decoded) : packet.flaw;
    text += fmt::format("    {:9.4f} s  {:<5} {:<30} {}{}{}\n", seconds(packet.start), name_of(packet.sender),
                        hex(packet.bytes), decoded.name, said.empty() ? "" : ": ", said);
  });
  for (const BusByte& byte : cycle.bytes) {
    listener.hear(byte);
  }
  listener.advance(Time::max());
  return text;
}

std::string tell(const Side& side, std::size_t place) {
  const auto& cycles = side.transcript.cycles();
  return fmt::format("  {}:\n{}", side.name, place < cycles.size() ? tell(cycles[place]) : "    no such cycle\n");
}

}  // namespace

void Transcript::on_byte(const BusByte& byte) {
  if (byte.sender == Sender::sr) {
    if (!sr_until_ || byte.start - *sr_until_ > cycle_pause) {
      cycles_.emplace_back();
    }
    sr_until_ = byte.end;
  }
  cycles_.back().bytes.push_back(byte);
}

std::size_t Transcript::byte_count() const {
  std::size_t count = 0;
  for (const Cycle& cycle : cycles_) {
    count += cycle.bytes.size();
  }
  return count;
}

std::uint64_t Transcript::hash() const {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto mix = [&](std::uint8_t byte) { hash = (hash ^ byte) * 0x100000001B3U; };
  for (const Cycle& cycle : cycles_) {
    mix(0xFF);
    for (const BusByte& byte : cycle.bytes) {
      mix(static_cast<std::uint8_t>(byte.sender));
      mix(byte.sent);
    }
  }
  return hash;
}

std::string tell_last_cycles(const Transcript& transcript, std::size_t count) {
  const auto& cycles = transcript.cycles();
  std::string text;
  for (std::size_t i = cycles.size() - std::min(count, cycles.size()); i < cycles.size(); ++i) {
    text += tell(cycles[i]);
  }
  return text;
}

std::optional<std::string> first_difference(const Side& one, const Side& other) {
  const auto& left = one.transcript.cycles();
  const auto& right = other.transcript.cycles();
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    const auto* here = i < left.size() ? &left[i] : nullptr;
    const auto* there = i < right.size() ? &right[i] : nullptr;
    if (here != nullptr && there != nullptr &&
        std::equal(here->bytes.begin(), here->bytes.end(), there->bytes.begin(), there->bytes.end(), is_same)) {
      continue;
    }
    return fmt::format("cycle {} differs\n{}{}", i, tell(one, i), tell(other, i));
  }
  return std::nullopt;
}

}  // namespace simulation::report
