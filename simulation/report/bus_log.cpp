#include "simulation/report/bus_log.hpp"

#include <fmt/format.h>

namespace simulation::report {
namespace {

constexpr Time cycle_pause = 5ms;  // as in the transcript
// After the remote's turn: whatever belongs to the cycle has been said, the answer and an attendant's turn included.
constexpr Time cycle_rest = 15ms;

Tone tone_of(const Packet& packet) {
  if (packet.kind == Packet::Kind::corrupt) {
    return Tone::alarm;
  }
  return packet.sender == Sender::sr ? Tone::sr : packet.sender == Sender::spm ? Tone::spm : Tone::plain;
}

bool is_typed(const Packet& packet) {
  return packet.is(bus::shark::Type::sr_hhp_data) || packet.is(bus::shark::Type::spm_hhp_data);
}

bool comes_now_and_then(const Packet& packet) {
  return packet.is(bus::shark::Type::spm_settings) || is_typed(packet);
}

// Even if it is the same again.
bool is_news_as_it_is(const Packet& packet) {
  return packet.kind == Packet::Kind::corrupt || is_typed(packet);
}

bool is_same(const Decoded& one, const Decoded& other) {
  return one.readings.size() == other.readings.size() && describe_change(one, other).empty();
}

}  // namespace

BusLog::BusLog(Page& page) : page_(page), listener_([this](const Packet& packet) { take(packet); }) {}

void BusLog::on_byte(const BusByte& byte) {
  if (byte.lost) {
    return;
  }
  if (byte.sender == Sender::sr) {
    if (!sr_until_ || byte.start - *sr_until_ > cycle_pause) {
      listener_.advance(byte.start);
      close_cycle();
    }
    sr_until_ = byte.end;
  }
  listener_.hear(byte);
}

void BusLog::on_sample(const Sample& sample) {
  listener_.advance(sample.at);
  if (sr_until_ && sample.at - *sr_until_ > cycle_rest) {
    close_cycle();
  }
  page_.advance(sample.at);
}

void BusLog::take(const Packet& packet) {
  if (packet.kind != Packet::Kind::finished) {
    cycle_.push_back({packet, false});
    return;
  }
  if (!cycle_.empty() && cycle_.back().packet.sender == packet.sender) {
    cycle_.back().has_finish = true;
  } else {
    cycle_.push_back({packet, true});
  }
}

// Everybody's last packet in a turn is followed by TF.
void BusLog::look_for_missing_finish() {
  for (std::size_t i = 0; i < cycle_.size(); ++i) {
    const bool is_last = i + 1 == cycle_.size() || cycle_[i + 1].packet.sender != cycle_[i].packet.sender;
    cycle_[i].lacks_finish = is_last && !cycle_[i].has_finish && cycle_[i].packet.kind == Packet::Kind::packet;
  }
}

void BusLog::close_cycle() {
  if (cycle_.empty()) {
    return;
  }
  look_for_missing_finish();
  const std::vector<std::string> shape = shape_of_cycle();
  // As long as the same packets come and go, only those that say something new are worth a line.
  const bool is_familiar = shape == shape_;
  shape_ = shape;
  bool is_folded = true;
  for (const Line& line : cycle_) {
    if (!is_familiar || says_something_new(line)) {
      unfold();
      print(line);
      is_folded = false;
    }
  }
  if (is_folded) {
    ++folded_;
    folded_until_ = cycle_.back().packet.end;
  }
  cycle_.clear();
}

std::vector<std::string> BusLog::shape_of_cycle() const {
  std::vector<std::string> shape;
  for (const Line& line : cycle_) {
    if (!comes_now_and_then(line.packet)) {
      shape.push_back(name_of(line.packet.sender) + decode(line.packet).name + (line.lacks_finish ? "!" : ""));
    }
  }
  return shape;
}

bool BusLog::says_something_new(const Line& line) const {
  const Decoded decoded = decode(line.packet);
  const auto before = latest_.find({line.packet.sender, decoded.name});
  return is_news_as_it_is(line.packet) || before == latest_.end() || !is_same(before->second, decoded);
}

void BusLog::print(const Line& line) {
  const Decoded decoded = decode(line.packet);
  const auto key = std::make_pair(line.packet.sender, decoded.name);
  const auto before = latest_.find(key);
  const bool is_first = before == latest_.end() || is_news_as_it_is(line.packet);
  std::string text = is_first ? describe(decoded) : describe_change(before->second, decoded);
  if (text.empty()) {
    text = line.packet.kind == Packet::Kind::finished ? "alone" : is_first ? "nothing set" : "unchanged";
  }
  latest_.insert_or_assign(key, decoded);
  page_.add(line.packet.start, Page::Source::bus, tone_of(line.packet),
            fmt::format("{:9.4f} s  {:<5} {:<12} {}{}", seconds(line.packet.start), name_of(line.packet.sender),
                        decoded.name, text, line.lacks_finish ? " (no TF)" : ""));
}

void BusLog::unfold() {
  if (folded_ > 0) {
    page_.add(folded_until_, Page::Source::bus, Tone::faint,
              fmt::format("             ... {} more {} like this, until {:.4f} s", folded_,
                          folded_ == 1 ? "cycle" : "cycles", seconds(folded_until_)));
    folded_ = 0;
  }
}

void BusLog::finish() {
  listener_.advance(Time::max());
  close_cycle();
  unfold();
}

}  // namespace simulation::report
