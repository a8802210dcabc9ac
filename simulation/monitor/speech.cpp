#include "simulation/monitor/speech.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/monitor/limits.hpp"

namespace simulation::monitor {
namespace {

constexpr std::uint8_t marker = 0x80;
constexpr std::uint8_t transmit_finished = 0x0F;
constexpr std::uint8_t general = 0x1;
constexpr std::uint8_t hhp_data = 0x3;
constexpr std::uint8_t power_up = 0x5;
constexpr std::uint8_t settings = 0xA;

// Of what a power module sends; 0 = it sends no such type. HHP data have 1 to 8.
constexpr std::array<std::uint8_t, 16> data_of = {0, 7, 0, 8, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};

bool may_have_length(std::uint8_t type, int length) {
  return type == hhp_data || data_of[type] == length;
}

}  // namespace

bool Speech::take(const BusByte& byte, const Turn& heard) {
  measure(byte);
  packet_ = std::nullopt;
  const bool begins = !is_open_ || byte.start - last_ > limits::speech_gap;
  if (begins) {
    if (is_open_ && !is_contended_) {
      blame("the turn before ended without TF");
    }
    begin(byte, heard);
  }
  last_ = byte.end;
  is_contended_ = is_contended_ || byte.lost || byte.spoiled || byte.heard != byte.sent;
  put(byte.sent, byte.end);
  return begins;
}

void Speech::begin(const BusByte& byte, const Turn& heard) {
  answered_ = heard;
  began_ = byte.start;
  is_open_ = true;
  is_contended_ = heard.is_doubtful;
  packets_ = missing_ = 0;
}

void Speech::measure(const BusByte& byte) {
  lately_.push_back(byte);
  on_time_ += byte.end - byte.start;
  while (lately_.front().end <= byte.end - limits::on_time_window) {
    on_time_ -= lately_.front().end - lately_.front().start;
    lately_.pop_front();
  }
}

void Speech::put(std::uint8_t value, Time end) {
  if (missing_ == 0 && value == transmit_finished) {
    if (packets_ == 0) {
      blame("TF without a packet");
    }
    is_open_ = false;
  } else if (missing_ == 0) {
    begin_packet(value);
  } else if ((value & marker) == 0) {
    blame(fmt::format("{:02X} in a packet has no marker", value));
  } else if (--missing_ > 0) {
    draft_.data[draft_.length++] = value & 0x7F;
    sum_ = static_cast<std::uint8_t>(sum_ + (value & 0x7F));
  } else {
    complete(value, end);
  }
}

void Speech::begin_packet(std::uint8_t start) {
  draft_ = Packet{};
  draft_.type = start & 0x0F;
  sum_ = start;
  const int length = (start >> 4 & 7) + 1;
  missing_ = length + 1;
  ++packets_;
  const bool answers_power_up = !answered_.general;
  const std::uint8_t first = answers_power_up ? power_up : general;
  if ((start & marker) != 0) {
    blame(fmt::format("{:02X} begins a packet", start));
  } else if (!may_have_length(draft_.type, length)) {
    blame(fmt::format("a power module sends no {:02X}", start));
  } else if (packets_ == 1 && draft_.type != first && !answered_.has_power_up) {
    blame("general information does not come first");
  } else if (answers_power_up && draft_.type != power_up) {
    blame("a power-up packet is answered with more than a power-up packet");
  }
}

void Speech::complete(std::uint8_t checksum, Time end) {
  if (checksum != (marker | (0x7F - (sum_ & 0x7F)))) {
    blame(fmt::format("checksum {:02X} is wrong", checksum));
    return;
  }
  draft_.kind = Packet::Kind::packet;
  draft_.end = end;
  packet_ = draft_;
}

void Speech::advance(Time now) {
  if (is_open_ && now - last_ > limits::speech_gap) {
    is_open_ = false;
    if (!is_contended_) {  // SB-1.4: a contended turn is abandoned
      blame(missing_ > 0 ? "a packet is broken off" : "the turn ended without TF");
    }
  }
}

bool Speech::is_late_or_early() const {
  if (answered_.is_doubtful) {
    return false;
  }
  if (!answered_.begun) {
    return true;
  }
  const Time delay = began_ - answered_.finished.value_or(answered_.last);
  return answered_.finished ? delay < limits::earliest_after_finish || delay > limits::latest_after_finish
                            : delay < limits::earliest_after_silence || delay > limits::latest_after_silence;
}

void Speech::blame(const std::string& flaw) {
  if (flaw_.empty()) {
    flaw_ = flaw;
  }
}

std::string Speech::tell() const {
  std::string text = answered_.begun ? fmt::format("it spoke {:.3f} ms after the {}",
                                                   milliseconds(began_ - answered_.finished.value_or(answered_.last)),
                                                   answered_.finished ? "TF" : "last character of a turn without TF")
                                     : "it spoke unasked";
  return flaw_.empty() ? text : text + "; " + flaw_;
}

}  // namespace simulation::monitor
