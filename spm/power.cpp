#include "spm/power.hpp"

#include "spm/limits.hpp"

namespace spm {

using namespace base;  // literals

void Power::general(const bus::shark::SrGeneral& packet, bool is_active, Millis sleep_after, Instant now) {
  confirm(packet.power_down_confirm);  // before the button: what is asked with this general cannot be answered by it
  button(packet.power_switch, now);
  if (is_active || packet.power_switch) {
    last_active_ = now;
  }
  if (!is_down_asked_ && sleep_after != 0_ms && now - last_active_ >= sleep_after) {  // SB-4.2
    is_sleep_asked_ = true;
    is_down_asked_ = true;
  }
}

void Power::button(bool is_down, Instant now) {
  switch (button_) {
    case Button::not_seen_up:
      if (!is_down) {
        button_ = Button::up;
      }
      break;
    case Button::up:
      if (is_down) {
        button_ = Button::down;
        pressed_ = now;
      }
      break;
    case Button::down:
      if (!is_down) {  // SB-4.1: bounce
        button_ = Button::up;
      } else if (now - pressed_ >= limits::shortest_press) {
        button_ = Button::accepted;
      }
      break;
    case Button::accepted:
      if (!is_down) {  // SB-4.1: not before the release
        button_ = Button::up;
        is_down_asked_ = true;
      }
      break;
  }
}

void Power::confirm(bool is_set) {
  if (!is_set || !is_down_asked_) {  // SB-4.3: only the answer to our own question counts
    confirms_ = 0;
    return;
  }
  if (confirms_ < limits::confirm_proof) {
    ++confirms_;
  }
  if (confirms_ >= limits::confirm_proof) {
    confirmed_.give();
    is_ending_ = true;
  }
}

void Power::step(bool is_safe, bool is_storing, Instant now) {
  const Millis patience = is_down_asked_ ? limits::unconfirmed_power_down : limits::lost_link_power_down;
  if (now - last_heard_ >= patience) {  // SB-4.4
    is_ending_ = true;
  }
  if (!is_ending_ || !is_safe) {  // SB-4.5
    return;
  }
  if (!is_leaving_) {
    is_leaving_ = true;
    left_ = now;
    if (confirmed_.is_given()) {
      return;  // one step for those who want to write the power-down itself
    }
  }
  if (!is_storing || now - left_ >= limits::longest_store_wait) {  // SB-4.3
    is_off_ = true;
  }
}

}  // namespace spm
