#include "spm/restart_watch.hpp"

namespace spm {

namespace {

constexpr uint8_t complement_of(uint8_t age) {
  return static_cast<uint8_t>(~age);
}

}  // namespace

void RestartWatch::begin(const Bytes& kept, Start start, base::Instant now) {
  counted_ = now;
  newest_ = older_ = long_ago;
  if (start != Start::power_on && is_whole(kept)) {  // H-25: a power cycle ends it
    newest_ = kept[0];
    older_ = kept[1];
  } else if (is_unexpected(start)) {  // lost, perhaps in a start that was reset while it tested RAM: that counts as one
    newest_ = 0;
  }
  if (is_unexpected(start) && !is_looping()) {
    const bool is_third = older_ <= within;
    older_ = is_third ? locked : newest_;
    newest_ = is_third ? locked : uint8_t{0};
  }
  grow_older(begin_takes);
}

bool RestartWatch::step(base::Instant now) {
  if (now - counted_ < base::Millis(unit)) {
    return false;
  }
  counted_ = counted_ + base::Millis(unit);
  grow_older(1);
  return true;
}

RestartWatch::Bytes RestartWatch::bytes() const {
  return Bytes{{newest_, older_, complement_of(newest_), complement_of(older_)}};
}

bool RestartWatch::is_whole(const Bytes& kept) {
  if (kept[2] != complement_of(kept[0]) || kept[3] != complement_of(kept[1])) {
    return false;
  }
  const bool is_locked = kept[0] == locked && kept[1] == locked;
  return is_locked || (kept[0] <= kept[1] && kept[1] <= long_ago);
}

void RestartWatch::grow_older(uint8_t units) {
  if (is_looping()) {
    return;
  }
  const uint8_t most = static_cast<uint8_t>(long_ago - units);
  newest_ = newest_ > most ? long_ago : static_cast<uint8_t>(newest_ + units);
  older_ = older_ > most ? long_ago : static_cast<uint8_t>(older_ + units);
}

}  // namespace spm
