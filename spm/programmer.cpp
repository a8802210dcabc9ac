#include "spm/programmer.hpp"

#include "bus/shark/codec.hpp"

namespace spm {

using namespace bus::shark;

namespace {

constexpr uint8_t most_at_once = 4;  // 80 characters in 20 ms, ten times what the bus brings

// SB-02.2: the programmer's display has characters of its own, of which four are also keys: 0x10 to 0x13.
constexpr bool is_printable(char character) {
  return (character >= ' ' && character <= '~') || (character >= '\x10' && character <= '\x13');
}

}  // namespace

bool Programmer::take(char& character) {
  if (!input_.take(character)) {
    return false;
  }
  is_losing_ = is_losing_ && !input_.empty();
  return true;
}

bool Programmer::put(char character) {
  return (static_cast<uint8_t>(character) & marker_bit) == 0 && output_.put(character);  // SB-03.2
}

uint8_t Programmer::hear(const HhpData& data) {
  uint8_t lost = 0;
  for (uint8_t i = 0; i < data.count; ++i) {
    if (!input_.put(static_cast<char>(data.characters[i]))) {
      ++lost;
    }
  }
  if (lost != 0) {
    is_losing_ = true;
    lost_ = static_cast<uint16_t>(lost_ > 0xFFFFU - lost ? 0xFFFFU : lost_ + lost);  // SB-02.1
  }
  return lost;
}

void Programmer::prepare() {
  const uint8_t ready = output_.size() < longest_data ? output_.size() : longest_data;
  if (is_in_turn_ || ready == packed_) {
    return;
  }
  HhpData data;
  for (uint8_t i = 0; i < ready; ++i) {
    data.characters[i] = static_cast<uint8_t>(output_[i]);
  }
  data.count = ready;
  packet_ = encode(data);
  packed_ = ready;
}

void Programmer::clear() {
  input_.clear();
  output_.clear();
  packed_ = 0;
  is_in_turn_ = false;
  is_losing_ = false;
}

void echo(Programmer& programmer) {
  char character;
  for (uint8_t i = 0; i < most_at_once && programmer.room() >= 2 && programmer.take(character); ++i) {
    if (character == '\r') {
      programmer.put('\r');
      programmer.put('\n');
    } else if (is_printable(character)) {
      programmer.put(character);
    }
  }
}

}  // namespace spm
