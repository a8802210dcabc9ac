#include "simulation/report/story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bus/shark/fields.hpp"
#include "simulation/report/decode.hpp"

namespace simulation::report {
namespace {

namespace general = bus::shark::spm_general;

constexpr double standstill = 0.01;   // m/s
constexpr double steady_band = 0.02;  // m/s
constexpr Time steady_after = 400ms;

bool reports(const Facts& facts, base::Field field) {
  return facts.spm_general() && base::is_set(facts.spm_general()->data(), field);
}

std::function<bool(const Facts&, const Sample&)> reported(base::Field field) {
  return [field](const Facts& facts, const Sample&) { return reports(facts, field); };
}

std::vector<Turning> make_turnings() {
  return {
      {false, [](const Facts&, const Sample& s) { return s.pins.power_latch; }, "the power latch holds",
       "the power latch lets go"},
      {false, [](const Facts&, const Sample& s) { return s.pins.left_brake_release && s.pins.right_brake_release; },
       "brakes release", nullptr},
      {true, [](const Facts&, const Sample& s) { return !s.pins.left_brake_release && !s.pins.right_brake_release; },
       "brakes engage", nullptr},
      {false, [](const Facts& f, const Sample&) { return f.is_driven(); }, "motors get voltage",
       "motors get no voltage any more"},
      {false, reported(general::slowdown), "the power module reports slowdown (LIMP)", "slowdown is over"},
      {false, reported(general::sr_drive_modified), "it waits for neutral", "neutral has been seen"},
      {false, reported(general::drive_inhibited), "driving is inhibited", "driving is allowed again"},
      {false, reported(general::sr_mode_invalid), "it refuses the operating mode", "it accepts the operating mode"},
      {false, reported(general::sacu_acknowledged), "it acknowledges the attendant control", nullptr},
      {false, reported(general::sacu_drives), "the attendant control drives", "the remote drives again"},
      {false, reported(general::sacu_mode_invalid), "it refuses the attendant's operating mode",
       "it accepts the attendant's operating mode"},
      {false, reported(general::power_down_now), "it asks the remote to power down", nullptr},
      {false, [](const Facts& f, const Sample&) { return !f.packets_of(Sender::spm).empty(); },
       "the power module says its first packet", nullptr},
  };
}

}  // namespace

Story::Story(const Facts& facts, Page& page, BusLog& log)
    : facts_(facts), page_(page), log_(log), stops_(facts), turnings_(make_turnings()) {}

void Story::say(const std::string& heading, Time at) {
  headings_.push_back({at, heading});
  log_.unfold();
  page_.add(at, Page::Source::story, Tone::plain, "");
  page_.add(at, Page::Source::story, Tone::heading, fmt::format("{:9.3f} s   == {} ==", seconds(at), heading));
}

void Story::note(const std::string& remark, Time at) {
  tell(fmt::format("({})", remark), at, Tone::faint);
}

void Story::tell_deed(const std::string& deed, Time at) {
  tell(deed, at, Tone::heading);
  stops_.on_cause(deed, at);
}

void Story::on_byte(const BusByte& byte) {
  if (facts_.answer_began_at() == byte.start) {
    answer_delays_.push_back(*facts_.answer_delay());
  }
}

void Story::on_wake(bool asserted, Time at) {
  tell(asserted ? "the wake level rises" : "the wake level falls", at);
}

void Story::on_power(bool powered, Time at) {
  tell(powered ? "the power module has its supply" : "the supply is gone", at);
}

void Story::on_sample(const Sample& sample) {
  stops_.on_sample(sample);
  tell_turnings(sample);
  tell_system_state(sample.at);
  tell_motion(sample);
  tell_stops(sample.at);
  page_.advance(sample.at);
}

void Story::tell(const std::string& sentence, Time at, Tone tone) {
  log_.unfold();
  page_.add(at, Page::Source::story, tone, fmt::format("{:9.3f} s   {}", seconds(at), sentence));
}

void Story::tell_turnings(const Sample& sample) {
  for (Turning& turning : turnings_) {
    const bool is = turning.is(facts_, sample);
    if (is != turning.was) {
      turning.was = is;
      const char* sentence = is ? turning.begins : turning.ends;
      if (sentence != nullptr) {
        tell(sentence, sample.at);
      }
    }
  }
}

void Story::tell_system_state(Time at) {
  if (!facts_.spm_general()) {
    return;
  }
  const int state = base::read(facts_.spm_general()->data(), general::system_state);
  if (state != system_state_) {
    system_state_ = state;
    system_states_.insert(state);
    tell(fmt::format("system state {:02X}: {}", state, system_state_name(state)), at);
  }
}

void Story::tell_motion(const Sample& sample) {
  const double speed = std::abs(facts_.speed());
  top_speed_ = std::max(top_speed_, speed);
  const bool is_moving = is_moving_ ? speed > standstill : speed > 3 * standstill;
  if (is_moving != is_moving_) {
    is_moving_ = is_moving;
    tell(is_moving ? (facts_.speed() > 0 ? "the chair rolls forward" : "the chair rolls backward") : "standstill",
         sample.at);
  }
  if (!is_moving || std::abs(speed - steady_speed_) > steady_band) {
    is_steady_ = false;
    steady_speed_ = speed;
    steady_since_ = sample.at;
  } else if (!is_steady_ && sample.at - steady_since_ >= steady_after) {
    is_steady_ = true;
    tell(fmt::format("steady at {:.2f} m/s", speed), sample.at);
  }
}

void Story::tell_stops(Time at) {
  for (; stops_told_ < stops_.all().size(); ++stops_told_) {
    const Stop& stop = stops_.all()[stops_told_];
    tell(fmt::format("{}: the motors began to slow {:.1f} ms later, standstill after {:.2f} s and {:.0f} cm",
                     stop.cause, milliseconds(stop.slowing_after), seconds(stop.still_after), stop.distance * 100),
         at);
  }
}

}  // namespace simulation::report
