#include "simulation/report/bus_log.hpp"

#include <fmt/format.h>

namespace simulation::report {
namespace {

constexpr Time cycle_pause = 5ms;  // as in the transcript

Tone tone_of(const Packet& packet) {
  if (packet.kind == Packet::Kind::corrupt) {
    return Tone::alarm;
  }
  return packet.sender == Sender::sr ? Tone::sr : packet.sender == Sender::spm ? Tone::spm : Tone::plain;
}

bool comes_now_and_then(const Packet& packet) {
  return packet.is(bus::shark::Type::spm_settings);
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
  page_.advance(sample.at);
}

void BusLog::take(const Packet& packet) {
  if (packet.kind != Packet::Kind::finished) {
    cycle_.push_back({packet, false});
    return;
  }
  if (!cycle_.empty() && cycle_.back().packet.sender == packet.sender) {
    cycle_.back().has_finished = true;
  } else {
    cycle_.push_back({packet, true});
  }
}

void BusLog::close_cycle() {
  if (cycle_.empty()) {
    return;
  }
  if (says_nothing_new()) {
    ++folded_;
    folded_until_ = cycle_.back().packet.end;
  } else {
    unfold();
    shape_.clear();
    for (const Line& line : cycle_) {
      print(line);
      if (!comes_now_and_then(line.packet)) {
        shape_.push_back(name_of(line.packet.sender) + decode(line.packet).name);
      }
    }
  }
  cycle_.clear();
}

bool BusLog::says_nothing_new() const {
  std::size_t place = 0;
  for (const Line& line : cycle_) {
    const Decoded decoded = decode(line.packet);
    const auto before = latest_.find({line.packet.sender, decoded.name});
    if (line.packet.kind == Packet::Kind::corrupt || before == latest_.end() || !is_same(before->second, decoded)) {
      return false;
    }
    if (comes_now_and_then(line.packet)) {
      continue;
    }
    if (place == shape_.size() || shape_[place++] != name_of(line.packet.sender) + decoded.name) {
      return false;
    }
  }
  return place == shape_.size();
}

void BusLog::print(const Line& line) {
  const Decoded decoded = decode(line.packet);
  const auto key = std::make_pair(line.packet.sender, decoded.name);
  const auto before = latest_.find(key);
  std::string text = before == latest_.end() ? describe(decoded) : describe_change(before->second, decoded);
  if (text.empty()) {
    text = "unchanged";
  }
  latest_.insert_or_assign(key, decoded);
  page_.add(line.packet.start, tone_of(line.packet),
            fmt::format("{:9.4f} s  {:<5} {:<12} {}{}", seconds(line.packet.start), name_of(line.packet.sender),
                        decoded.name, text, line.packet.kind == Packet::Kind::finished ? "alone" : ""));
}

void BusLog::unfold() {
  if (folded_ > 0) {
    page_.add(folded_until_, Tone::faint,
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
