// What the chair does, told in sentences with times, and counted for the table at the end.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "simulation/report/bus_log.hpp"
#include "simulation/report/facts.hpp"
#include "simulation/report/page.hpp"
#include "simulation/report/stops.hpp"

namespace simulation::report {

// A yes or no whose changes are worth a line.
struct Turning {
  bool was = false;
  std::function<bool(const Facts&, const Sample&)> is;
  const char* begins;
  const char* ends;  // null: its end is not told
};

class Story : public Observer {
 public:
  struct Moment {
    Time at{};
    std::string text;
  };

  // All must outlive the story; facts and log observe the world before it does.
  Story(const Facts& facts, Page& page, BusLog& log);

  void say(const std::string& heading, Time at);
  void note(const std::string& remark, Time at);
  // Somebody did something to the chair: "the cable is cut".
  void tell_deed(const std::string& deed, Time at);

  void on_byte(const BusByte& byte) override;
  void on_wake(bool asserted, Time at) override;
  void on_power(bool powered, Time at) override;
  void on_sample(const Sample& sample) override;

  const std::vector<Moment>& headings() const { return headings_; }
  const std::vector<Stop>& stops() const { return stops_.all(); }
  const std::vector<Time>& answer_delays() const { return answer_delays_; }
  const std::set<int>& system_states() const { return system_states_; }
  double top_speed() const { return top_speed_; }

 private:
  void tell(const std::string& sentence, Time at, Tone tone = Tone::story);
  void tell_turnings(const Sample& sample);
  void tell_motion(const Sample& sample);
  void tell_system_state(Time at);
  void tell_stops(Time at);

  const Facts& facts_;
  Page& page_;
  BusLog& log_;
  Stops stops_;
  std::vector<Turning> turnings_;
  std::vector<Moment> headings_;
  std::vector<Time> answer_delays_;
  std::set<int> system_states_;
  int system_state_ = -1;
  std::size_t stops_told_ = 0;
  bool is_moving_ = false;
  bool is_steady_ = false;
  double steady_speed_ = 0;
  Time steady_since_{};
  double top_speed_ = 0;
};

}  // namespace simulation::report
