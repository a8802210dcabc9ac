// The hand-held programmer (HHP) at the remote's charger port: a keyboard and a screen. Its characters have eight bits;
// what the bus can carry of them is the remote's business (SB-02.2, SB-03.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace simulation {

class Programmer {
 public:
  void type(const std::string& text) { typed_ += text; }
  void clear_screen() { screen_.clear(); }
  // Everything that has come since the screen was cleared.
  const std::string& screen() const { return screen_; }

  // The remote's side: the oldest characters that it has not taken yet, and one for the screen.
  std::string take(std::size_t most) {
    const std::string taken = typed_.substr(0, most);
    typed_.erase(0, taken.size());
    return taken;
  }
  void show(std::uint8_t character) { screen_ += static_cast<char>(character); }

 private:
  std::string typed_;
  std::string screen_;
};

}  // namespace simulation
