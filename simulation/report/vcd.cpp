#include "simulation/report/vcd.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <ostream>

namespace simulation::report {
namespace {

enum Signal : std::size_t { bus, wake, supply, first_pin };

struct PinRow {
  const char* name;
  bool (*level)(const Pins&);
};

const std::array pins{
    PinRow{"power_latch", [](const Pins& p) { return p.power_latch; }},
    PinRow{"bridge_enable", [](const Pins& p) { return p.bridge_enable; }},
    PinRow{"motor_relay", [](const Pins& p) { return p.motor_relay; }},
    PinRow{"left_forward", [](const Pins& p) { return p.left_forward; }},
    PinRow{"right_forward", [](const Pins& p) { return p.right_forward; }},
    PinRow{"left_pwm_on", [](const Pins& p) { return p.left_duty > 0; }},
    PinRow{"right_pwm_on", [](const Pins& p) { return p.right_duty > 0; }},
    PinRow{"left_brake_release", [](const Pins& p) { return p.left_brake_release; }},
    PinRow{"right_brake_release", [](const Pins& p) { return p.right_brake_release; }},
    PinRow{"left_indicator", [](const Pins& p) { return p.left_indicator; }},
    PinRow{"right_indicator", [](const Pins& p) { return p.right_indicator; }},
    PinRow{"headlight", [](const Pins& p) { return p.headlight; }},
    PinRow{"status_led", [](const Pins& p) { return p.status_led; }},
};

// Between ten bits and eleven, whatever the sender's clock.
constexpr Time shortest_with_two_stop_bits = 273us;

constexpr std::size_t signal_count = first_pin + pins.size();

// The bus idles high; every other signal starts low.
constexpr bool idle_level(std::size_t signal) {
  return signal == bus;
}

char identifier(std::size_t signal) {
  return static_cast<char>('!' + static_cast<int>(signal));
}

const char* name_of_signal(std::size_t signal) {
  constexpr std::array<const char*, first_pin> lines{"bus", "wake", "supply"};
  return signal < first_pin ? lines[signal] : pins[signal - first_pin].name;
}

std::int64_t ticks(Time at) {
  return (at.count() + 50) / 100;
}

}  // namespace

Waveform::Waveform() : levels_(signal_count) {
  levels_[bus] = true;
}

void Waveform::on_byte(const BusByte& byte) {
  end_ = std::max(end_, byte.end);
  if (byte.lost) {
    return;
  }
  // Start bit, eight data bits from the lowest, stop bits; a spoiled character keeps its first stop bit down.
  const unsigned frame = 0x600U | (byte.heard * 2U);
  const unsigned line = byte.spoiled ? frame & ~0x200U : frame;
  const Time length = byte.end - byte.start;
  const int bits = length < shortest_with_two_stop_bits ? 10 : 11;
  for (int bit = 0; bit < bits; ++bit) {
    if ((line >> bit & 1U) == 0) {
      dominant_.push_back({byte.start + length * bit / bits, byte.start + length * (bit + 1) / bits});
    }
  }
}

void Waveform::on_wake(bool asserted, Time at) {
  set(wake, asserted, at);
}

void Waveform::on_power(bool powered, Time at) {
  set(supply, powered, at);
}

void Waveform::on_sample(const Sample& sample) {
  for (std::size_t i = 0; i < pins.size(); ++i) {
    set(first_pin + i, pins[i].level(sample.pins), sample.at);
  }
  end_ = std::max(end_, sample.at);
}

void Waveform::set(std::size_t signal, bool level, Time at) {
  if (levels_[signal] != level) {
    levels_[signal] = level;
    changes_.push_back({at, signal, level});
  }
}

std::vector<Waveform::Change> Waveform::bus_changes() const {
  auto intervals = dominant_;
  std::sort(intervals.begin(), intervals.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  std::vector<Change> edges;
  for (const Dominant& next : intervals) {
    if (!edges.empty() && next.from <= edges.back().at) {
      edges.back().at = std::max(edges.back().at, next.to);  // the line is still down
    } else {
      edges.push_back({next.from, bus, false});
      edges.push_back({next.to, bus, true});
    }
  }
  return edges;
}

void Waveform::write(std::ostream& out) const {
  out << "$comment Pilotfish: one-bit signals; pins sampled every millisecond, bus edges exact $end\n"
         "$timescale 100 ns $end\n$scope module chair $end\n";
  for (std::size_t signal = 0; signal < signal_count; ++signal) {
    fmt::print(out, "$var wire 1 {} {} $end\n", identifier(signal), name_of_signal(signal));
  }
  out << "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n";
  for (std::size_t signal = 0; signal < signal_count; ++signal) {
    fmt::print(out, "{}{}\n", idle_level(signal) ? 1 : 0, identifier(signal));
  }
  out << "$end\n";

  auto all = bus_changes();
  all.insert(all.end(), changes_.begin(), changes_.end());
  std::stable_sort(all.begin(), all.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
  std::int64_t now = 0;
  for (const Change& change : all) {
    if (ticks(change.at) != now) {
      now = ticks(change.at);
      fmt::print(out, "#{}\n", now);
    }
    fmt::print(out, "{}{}\n", change.level ? 1 : 0, identifier(change.signal));
  }
  fmt::print(out, "#{}\n", std::max(ticks(end_), now + 1));
}

}  // namespace simulation::report
