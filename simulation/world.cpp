#include "simulation/world.hpp"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

constexpr Time tick = 1ms;
constexpr Time supply_hold = 250ms;  // the capacitor at the power latch

// Remote or attendant control: a model with a clock of its own.
template <typename Model>
class ModelNode final : public WireNode {
 public:
  explicit ModelNode(Model& model) : model_(model) {}
  CharacterFormat format() const { return {Time(std::llround(model_.timing.bit_us * 1000)), model_.timing.stop_bits}; }
  Time bit_time() const override { return format().bit; }
  void hear(const Reception& reception) override { model_.hear(reception); }

 private:
  Model& model_;
};

class BoardNode final : public WireNode {
 public:
  explicit BoardNode(SpmBoard& board) : board_(board) {}
  CharacterFormat format() const { return {board_.bit_time(), 2}; }
  Time bit_time() const override { return board_.bit_time(); }
  void hear(const Reception& reception) override { board_.hear(reception); }

 private:
  SpmBoard& board_;
};

}  // namespace

struct World::Parts {
  Parts(std::unique_ptr<SpmBoard> the_board, std::uint64_t seed)
      : board(std::move(the_board)), wire(seed), remote_node(remote), sacu_node(sacu), board_node(*board) {
    wire.attach(WireEnd::remote, remote_node);
    wire.attach(WireEnd::power_module, board_node);
    wire.on_byte([this](const BusByte& byte) { tell([&](Observer& observer) { observer.on_byte(byte); }); });
    wire.on_wake([this](bool asserted, Time at) { change_wake(asserted, at); });
    remote.on_wake([this](bool asserted, Time at) { wire.hold_wake(asserted, at); });
    remote.on_transmit(
        [this](std::uint8_t value, Time start) { wire.send(Sender::sr, value, start, remote_node.format()); });
    sacu.on_transmit(
        [this](std::uint8_t value, Time start) { wire.send(Sender::sacu, value, start, sacu_node.format()); });
    board->on_speak(
        [this](std::uint8_t value, Time start) { wire.send(Sender::spm, value, start, board_node.format()); });
    surround_board();
    take_sample();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  // Events of one moment happen in the order of these lines.
  void run_until(Time limit) {
    while (now < limit) {
      const Time next = std::min({limit, next_tick, remote.next_time(), sacu.next_time(), wire.next_time()});
      now = std::clamp(board->run_until(next), now, next);  // less than asked for if it began a character
      wire.advance(now);
      if (remote.next_time() <= now) {
        remote.act(now);
      }
      if (sacu.next_time() <= now) {
        sacu.act(now);
      }
      if (next_tick <= now) {
        next_tick += tick;
        pass_a_tick();
      }
    }
  }

  void pass_a_tick() {
    feed_board(wire.is_wake_asserted() || board->pins().power_latch);
    chair.apply(board->pins());
    chair.step(tick);
    surround_board();
    take_sample();
    tell([this](Observer& observer) { observer.on_sample(sample); });
  }

  void change_wake(bool asserted, Time at) {
    tell([&](Observer& observer) { observer.on_wake(asserted, at); });
    feed_board(true);  // up to the end of wake
    surround_board();
  }

  // Whoever holds the supply holds it for a while longer.
  void feed_board(bool is_held) {
    if (is_held) {
      supplied_until = now + supply_hold;
    }
    const bool is_supplied = is_module_fitted && now < supplied_until;
    if (is_supplied != board->is_powered()) {
      board->power(is_supplied, now);
      tell([&](Observer& observer) { observer.on_power(is_supplied, now); });
    }
  }

  void surround_board() {
    surroundings.wake = wire.is_wake_asserted();
    surroundings.analog_volts = chair.analog_volts();
    board->surround(surroundings);
  }

  void take_sample() {
    sample.at = now;
    sample.pins = board->pins();
    sample.spm_powered = board->is_powered();
    sample.resets = board->statistics().resets;
    sample.controls = remote.controls;
    sample.chair = chair.state();
  }

  template <typename Tell>
  void tell(Tell each) const {
    for (Observer* observer : observers) {
      each(*observer);
    }
  }

  std::unique_ptr<SpmBoard> board;
  Wire wire;
  Remote remote;
  Sacu sacu;
  Chair chair;
  ModelNode<Remote> remote_node;
  ModelNode<Sacu> sacu_node;
  BoardNode board_node;
  Surroundings surroundings;
  Sample sample;
  std::vector<Observer*> observers;
  Time now{};
  Time next_tick = tick;
  Time supplied_until{};
  bool is_module_fitted = true;
};

World::World(std::unique_ptr<SpmBoard> board, std::uint64_t seed)
    : parts_(std::make_unique<Parts>(std::move(board), seed)) {}

World::~World() = default;

Time World::now() const {
  return parts_->now;
}

void World::run_for(Time span) {
  run_until(now() + span);
}

void World::run_until(Time limit) {
  parts_->run_until(limit);
}

void World::observe(Observer& observer) {
  parts_->observers.push_back(&observer);
}

SpmBoard& World::board() {
  return *parts_->board;
}

Wire& World::wire() {
  return parts_->wire;
}

Remote& World::remote() {
  return parts_->remote;
}

Sacu& World::sacu() {
  return parts_->sacu;
}

void World::attach_sacu() {
  if (!sacu().is_attached()) {
    sacu().attach();
    parts_->wire.attach(WireEnd::power_module, parts_->sacu_node, now());
  }
}

void World::detach_sacu() {
  sacu().detach();
  parts_->wire.detach(parts_->sacu_node);
}

void World::say_as(Sender sender, const std::vector<std::uint8_t>& values) {
  const Time until = now() + static_cast<Time::rep>(values.size()) * CharacterFormat{}.length();
  if (sender == Sender::sr) {
    remote().be_spoken_for(until);
  } else if (sender == Sender::sacu) {
    sacu().be_spoken_for(until);
  }
  wire().send(sender, values, now());
}

void World::ask_for_slow(bool is_asked) {
  parts_->surroundings.dci_slowdown = is_asked;
  parts_->surround_board();
}

void World::fit_lighting(bool is_fitted) {
  parts_->surroundings.lighting_fitted = is_fitted;
  parts_->surround_board();
}

void World::fit_power_module(bool is_fitted) {
  parts_->is_module_fitted = is_fitted;
}

Chair& World::chair() {
  return parts_->chair;
}

bool World::spm_powered() const {
  return parts_->board->is_powered();
}

const Sample& World::latest() const {
  return parts_->sample;
}

}  // namespace simulation
