// The bus in words: one line a packet, only what changed since the last packet of its kind; in a cycle of the usual
// packets, only those that say something new; cycles that say nothing new folded into one line.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simulation/report/decode.hpp"
#include "simulation/report/page.hpp"
#include "simulation/world.hpp"

namespace simulation::report {

class BusLog : public Observer {
 public:
  // Lines go to `page`; it and the world may outlive the log's last call, not the other way round.
  explicit BusLog(Page& page);

  void on_byte(const BusByte& byte) override;
  void on_sample(const Sample& sample) override;

  // Ends a folded run, so that what is printed next stands after it.
  void unfold();
  // After the last sample: the cycle in progress and the last fold.
  void finish();

 private:
  struct Line {
    Packet packet;
    bool has_finish = false;    // TF followed
    bool lacks_finish = false;  // it should have
  };

  void take(const Packet& packet);
  void look_for_missing_finish();
  void close_cycle();
  std::vector<std::string> shape_of_cycle() const;
  bool says_something_new(const Line& line) const;
  void print(const Line& line);

  Page& page_;
  Listener listener_;
  std::vector<Line> cycle_;
  std::map<std::pair<Sender, std::string>, Decoded> latest_;
  std::vector<std::string> shape_;  // who said what in the last cycle, without settings
  std::size_t folded_ = 0;
  Time folded_until_{};
  std::optional<Time> sr_until_;
};

}  // namespace simulation::report
