#include "simulation/bench/bus_meter.hpp"

#include <algorithm>

namespace simulation::bench {
namespace {

constexpr std::uint8_t end_of_turn = 0x0F;
constexpr Time period = 20ms;         // SB-2.2
constexpr Time between_cycles = 5ms;  // no sender pauses that long within a turn

double micro(Time time) {
  return static_cast<double>(time.count()) / 1000;
}

}  // namespace

void BusMeter::begin() {
  answer_.clear();
  pause_.clear();
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    lengths_[i].clear();
    bytes_[i].clear();
  }
  end_of_talk_.clear();
  utilisation_.clear();
  cycles_ = broken_ = broken_by_sacu_ = spoiled_ = 0;
  has_begun_ = false;
}

void BusMeter::on_byte(const BusByte& byte) {
  const bool is_new_turn = byte.sender != last_sender_ || byte.start - last_end_ > between_cycles;
  if (byte.sender == Sender::sr && is_new_turn) {
    begin_cycle(byte);
  }
  const bool is_in_the_way = byte.sender != last_sender_ && byte.start < last_end_;
  is_disturbed_ = is_disturbed_ || is_in_the_way || byte.sender == Sender::noise;
  spoiled_ += byte.spoiled || byte.lost || byte.heard != byte.sent ? 1 : 0;
  if (has_begun_) {
    switch (byte.sender) {
      case Sender::sr:
        extend(cycle_.sr, byte);
        break;
      case Sender::spm:
        if (cycle_.spm.bytes > 0) {
          pause_.add(micro(byte.start - cycle_.spm.until));
        } else if (cycle_.sr.has_ended) {
          answer_.add(micro(byte.start - cycle_.sr.until));
        }
        extend(cycle_.spm, byte);
        break;
      case Sender::sacu:
        extend(cycle_.sacu, byte);
        break;
      case Sender::noise:
      case Sender::tester:
        break;
    }
  }
  last_sender_ = byte.sender;
  last_end_ = std::max(last_end_, byte.end);
}

void BusMeter::begin_cycle(const BusByte& byte) {
  if (has_begun_) {
    close_cycle(byte.start);
  }
  cycle_ = {};
  is_disturbed_ = false;
  has_begun_ = true;
}

void BusMeter::extend(Turn& turn, const BusByte& byte) {
  if (turn.bytes == 0) {
    turn.from = byte.start;
  }
  is_disturbed_ = is_disturbed_ || turn.has_ended;  // it speaks on behind its own TF
  turn.until = byte.end;
  ++turn.bytes;
  turn.has_ended = byte.sent == end_of_turn;
}

void BusMeter::close_cycle(Time next) {
  history_.push_back(cycle_);
  ++cycles_;
  const bool is_whole = cycle_.sr.has_ended && cycle_.spm.has_ended && !is_disturbed_ && cycle_.last_end() <= next;
  broken_ += is_whole ? 0 : 1;
  broken_by_sacu_ += cycle_.sacu.has_ended ? 0 : 1;
  const std::array<const Turn*, 3> turns{&cycle_.sr, &cycle_.spm, &cycle_.sacu};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (turns[i]->bytes > 0) {
      lengths_[i].add(micro(Cycle::length(*turns[i])));
      bytes_[i].add(turns[i]->bytes);
    }
  }
  end_of_talk_.add(micro(cycle_.last_end() - cycle_.sr.from));
  utilisation_.add(micro(cycle_.busy()) / micro(period));
}

void BusMeter::tell(RunFigures& figures) const {
  figures.answer = answer_.spread();
  figures.pause = pause_.spread();
  figures.sr = {lengths_[0].spread(), bytes_[0].spread()};
  figures.spm = {lengths_[1].spread(), bytes_[1].spread()};
  figures.sacu = {lengths_[2].spread(), bytes_[2].spread()};
  figures.end_of_talk = end_of_talk_.spread();
  figures.cycles = cycles_;
  figures.broken_cycles = broken_ + (figures.has_sacu ? broken_by_sacu_ : 0);
  figures.utilisation = utilisation_.spread();
  figures.losses.spoiled = spoiled_;
}

std::optional<double> BusMeter::busy_us(int sr_bytes, int spm_bytes, int sacu_bytes) const {
  Readings busy;
  for (const Cycle& cycle : history_) {
    if (cycle.sr.bytes == sr_bytes && cycle.spm.bytes == spm_bytes && cycle.sacu.bytes == sacu_bytes) {
      busy.add(micro(cycle.busy()));
    }
  }
  const Spread spread = busy.spread();
  return spread.count > 0 ? std::optional(spread.median) : std::nullopt;
}

}  // namespace simulation::bench
