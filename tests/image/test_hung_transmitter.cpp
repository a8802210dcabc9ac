// The flashed image's transmitter does not come to an end: seen on the wire.
#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"
#include "simulation/world.hpp"

namespace simulation {
namespace {

struct SpmBytes final : Observer {
  void on_byte(const BusByte& byte) override {
    if (byte.sender == Sender::spm) {
      starts.push_back(byte.start);
    }
  }
  std::vector<Time> starts;
};

struct Link {
  Link() {
    auto owned = make_avr_board_with_insight({.image = std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf"});
    chip = owned.get();
    world = std::make_unique<World>(std::move(owned));
    world->observe(spm);
    world->remote().start(world->now());
    world->run_for(1s);
    // Into the middle of a turn.
    const std::size_t before = spm.starts.size();
    while (spm.starts.size() < before + 4 || spm.starts.back() - spm.starts[spm.starts.size() - 4] > 1ms) {
      world->run_for(50us);
    }
    at = world->now();
  }
  // Characters that began between two moments after the upset.
  int said(Time from, Time to) const {
    int count = 0;
    for (const Time start : spm.starts) {
      count += start >= at + from && start < at + to ? 1 : 0;
    }
    return count;
  }
  bool has_event(std::uint8_t code) const {
    const auto eeprom = chip->eeprom();
    for (std::size_t record = 2048; record < eeprom.size(); record += 8) {
      if (eeprom[record] == code) {
        return true;
      }
    }
    return false;
  }
  void check_link_goes_on() {
    CHECK(said(60ms, 160ms) >= 5 * 10);  // five answers of ten characters
    CHECK(chip->statistics().resets == 0);
    CHECK(world->remote().statistics().bad <= 30);
  }

  AvrBoard* chip;
  std::unique_ptr<World> world;
  SpmBytes spm;
  Time at{};  // of the upset
};

constexpr std::uint16_t uart_control = 0xC1;  // UCSR0B
constexpr unsigned data_empty_interrupt = 0x20;

}  // namespace

TEST_CASE("a turn that gets stuck under way is given up, and the link goes on", "[H-30]") {
  Link link;
  const unsigned control = link.chip->ram(uart_control);
  REQUIRE((control & data_empty_interrupt) != 0);
  link.chip->write_ram(uart_control, static_cast<std::uint8_t>(control & ~data_empty_interrupt));
  link.world->run_for(1s);
  CHECK(link.said(1ms, 15ms) == 0);
  CHECK(link.has_event(40));
  link.check_link_goes_on();
}

// Behind the turn's bytes lie some that change while it speaks, so the echo differs even before the time is up.
TEST_CASE("a turn whose length was upset ends within 10 ms", "[H-30]") {
  Link link;
  const auto sender = link.chip->address_of("_ZN12_GLOBAL__N_16senderE");
  REQUIRE(sender);
  const auto size_of_turn = static_cast<std::uint16_t>((*sender & 0xFFFFU) + 24);
  REQUIRE(link.chip->ram(size_of_turn) >= 10);
  link.chip->write_ram(size_of_turn, 200);  // 57 ms
  link.world->run_for(1s);
  CHECK(link.said(0ms, 7ms) > 20);
  CHECK(link.said(10ms, 15ms) == 0);
  link.check_link_goes_on();
}

}  // namespace simulation
