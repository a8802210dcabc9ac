// The flashed image from reset to its loop: what it tests, how long that takes, and what becomes of it if something is
// found (SB-1.2, H-22, H-25, H-27).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"
#include "simulation/board/avr_core.hpp"
#include "simulation/board/avr_image.hpp"
#include "simulation/board/host_board.hpp"
#include "simulation/world.hpp"

namespace simulation {
namespace {

constexpr std::uint16_t tccr0b = 0x45;  // not 0: the clocks run, the loop is next
constexpr std::uint16_t gpior2 = 0x4B;  // the result of the self-test
constexpr unsigned all_passed = 0x5A;
constexpr unsigned flash_failed = 0x3C;
constexpr unsigned ram_failed = 0x00;

constexpr std::size_t log_at = 2048;
constexpr std::size_t places = 256;

std::string image() {
  return std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf";
}

struct Chip {
  Chip() : board(make_avr_board_with_insight({.image = image()})) {}

  void run(Time span) {
    const Time limit = now + span;
    while (now < limit) {
      now = board->run_until(limit);
    }
  }
  void turn_off_and_on() {
    board->power(false, now);
    board->power(true, now);
  }
  // Runs up to the moment at which `is_reached`, to 10 us; gives up after 400 ms.
  template <typename Reached>
  Time time_until(Reached is_reached) {
    const Time from = now;
    while (!is_reached() && now - from < 400ms) {
      run(10us);
    }
    return now - from;
  }
  unsigned result() const { return board->ram(gpior2); }
  // A duty alone, without bridge and relay, is none: in a program with a wrong bit it may be anything.
  bool is_safe() const {
    const Pins pins = board->pins();
    return !pins.bridge_enable && !pins.motor_relay && !pins.left_brake_release && !pins.right_brake_release;
  }
  // How often the log holds this event.
  int logged(unsigned code, unsigned argument) const {
    const auto eeprom = board->eeprom();
    int count = 0;
    for (std::size_t place = 0; place < places; ++place) {
      count += eeprom[log_at + 8 * place] == code && eeprom[log_at + 8 * place + 1] == argument ? 1 : 0;
    }
    return count;
  }

  std::unique_ptr<AvrBoard> board;
  Time now{};
};

Upset flash_bit(std::size_t address, int bit) {
  Upset upset;
  upset.address = static_cast<std::uint32_t>(address);
  upset.bit = bit;
  return upset;
}

Upset stuck_bit(unsigned address, int bit, bool is_high) {
  Upset upset;
  upset.memory = Upset::Memory::ram;
  upset.address = address;
  upset.bit = bit;
  upset.is_stuck_high = is_high;
  return upset;
}

// Each flip is tried in a chip of its own power-up. No program begins with one, found or not.
void find_flips(std::size_t count) {
  const std::size_t size = load_avr_image(image()).flash.size();
  std::vector<std::pair<std::size_t, int>> flips;
  for (int bit = 0; bit < 8; ++bit) {
    flips.emplace_back(0, bit);
    flips.emplace_back(size - 1, bit);
    flips.emplace_back(0x94FF, bit);  // erased flash behind the image is checked as well
  }
  for (std::size_t i = 0; i < count; ++i) {
    flips.emplace_back(i * size / count, static_cast<int>(i % 8));
  }
  std::size_t found = 0;
  std::size_t dead = 0;
  Chip chip;
  for (const auto& [address, bit] : flips) {
    CAPTURE(address, bit);
    chip.board->upset(flash_bit(address, bit));
    chip.turn_off_and_on();
    chip.run(245ms);
    const bool is_loop_reached = chip.board->ram(tccr0b) != 0;
    const bool is_found = chip.result() == flash_failed || chip.result() == ram_failed;
    found += is_found ? 1 : 0;
    dead += is_found ? 0 : 1;
    CHECK_FALSE(is_loop_reached);
    CHECK(chip.is_safe());
    chip.board->upset(flash_bit(address, bit));
  }
  CHECK(found + dead == flips.size());
  CHECK(dead * 10 < flips.size());  // vectors, and what runs before the check
}

}  // namespace

TEST_CASE("the latch is held within 1 ms of the first instruction, and the loop runs within 250 ms", "[SB-1.2][H-27]") {
  Chip chip;
  chip.board->power(true, chip.now);
  CHECK(chip.time_until([&] { return chip.board->pins().power_latch; }) <= 1ms);
  const Time tested = chip.time_until([&] { return chip.result() == all_passed; });
  const Time to_loop = chip.time_until([&] { return chip.board->ram(tccr0b) != 0; });
  CAPTURE(tested.count(), to_loop.count());
  CHECK(tested > 150ms);
  CHECK(chip.now <= 250ms);
  CHECK(chip.result() == all_passed);
  chip.run(1s);
  CHECK(chip.result() == all_passed);
  CHECK(chip.board->statistics().resets == 0);
  CHECK(chip.board->statistics().complaints.empty());
}

TEST_CASE("the host board starts as late as the image", "[H-27]") {
  Chip chip;
  chip.board->power(true, chip.now);
  const Time on_chip = chip.time_until([&] { return chip.board->ram(tccr0b) != 0; });
  CAPTURE(on_chip.count());
  CHECK(host_start_up - on_chip < 100us);
  CHECK(on_chip - host_start_up < 100us);
}

TEST_CASE("the image, as ELF and as HEX, carries the checksum that it checks", "[H-27]") {
  for (const std::string suffix : {".elf", ".hex"}) {
    CAPTURE(suffix);
    std::vector<std::uint8_t> flash = load_avr_image(std::string(PILOTFISH_IMAGE_DIR) + "/spm" + suffix).flash;
    flash.resize(0x9500, 0xFF);
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : flash) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) {
        crc = (crc & 1U) != 0 ? crc >> 1 ^ 0x8408U : crc >> 1;
      }
    }
    CHECK(crc == 0x6996);
  }
}

TEST_CASE("a flipped bit of the flash is found at the start", "[H-27]") {
  find_flips(200);
}

TEST_CASE("2000 flipped bits of the flash are found at the start", "[.long][H-27]") {
  find_flips(2000);
}

TEST_CASE("a flash that changes later is found within a round", "[H-27]") {
  Chip chip;
  chip.board->power(true, chip.now);
  chip.run(1s);
  chip.board->upset(flash_bit(0x9470, 4));  // behind the program, so that only the check can notice
  chip.run(105s);
  CHECK(chip.logged(33, 3) == 1);
  CHECK(chip.logged(33, 1) == 0);
  CHECK(chip.is_safe());
}

TEST_CASE("a stuck bit of RAM is found wherever it is, before it does harm", "[H-27]") {
  const AvrImage symbols = load_avr_image(image());
  const unsigned end = symbols.address_of("_end").value();
  const unsigned bss = symbols.address_of("__bss_start").value();
  for (const unsigned address : {0x100U, 0x101U, 0x2A7U, bss - 1, bss, bss + 50, end - 1, end, end + 20, 0x1000U,
                                 0x2BCDU, 0x40B0U, 0x40F0U, 0x40FCU, 0x40FEU, 0x40FFU}) {
    for (const bool is_high : {false, true}) {
      const int bit = static_cast<int>(address * 5 % 8);
      CAPTURE(address, bit, is_high);
      Chip chip;
      chip.board->upset(stuck_bit(address, bit, is_high));
      chip.board->power(true, chip.now);
      chip.run(1ms);
      CHECK(chip.board->pins().power_latch);
      chip.run(300ms);
      CHECK(chip.result() == ram_failed);
      CHECK(chip.is_safe());
    }
  }
}

// March C-: whichever of the two lies lower, whichever way the one changes, whatever that does to the other.
TEST_CASE("a bit of RAM that disturbs another when it changes is found", "[H-27]") {
  enum class Does { nothing, clears, sets, inverts };
  struct Place {
    unsigned address;
    int bit;
  };
  const auto result_with = [](Place disturber, Place victim, bool is_rising, Does does) {
    AvrCore core("atmega1284p", 8'000'000, load_avr_image(image()));
    core.reset(ResetKind::power_on);
    core.run(800'000);  // in the midst of the flash's test
    auto& data = core.avr().data;
    const unsigned mask = 1U << victim.bit;
    while (core.now() < 1'805'000) {
      const bool was = (data[disturber.address] >> disturber.bit & 1U) != 0;
      core.run(core.now() + 1);
      const bool is = (data[disturber.address] >> disturber.bit & 1U) != 0;
      if (was != is && is == is_rising && does != Does::nothing) {
        unsigned byte = data[victim.address];
        byte = does == Does::clears ? byte & ~mask : does == Does::sets ? byte | mask : byte ^ mask;
        data[victim.address] = static_cast<std::uint8_t>(byte);
      }
    }
    return unsigned{data[gpior2]};
  };
  CHECK(result_with({0x1000, 1}, {0x1001, 1}, true, Does::nothing) == all_passed);
  const std::vector<std::pair<Place, Place>> pairs{
      {{0x1000, 1}, {0x1001, 1}}, {{0x1001, 2}, {0x1000, 3}}, {{0x0234, 7}, {0x3F00, 0}}, {{0x3F00, 4}, {0x0234, 6}}};
  for (const auto& [disturber, victim] : pairs) {
    for (const bool is_rising : {false, true}) {
      for (const Does does : {Does::clears, Does::sets, Does::inverts}) {
        CAPTURE(disturber.address, victim.address, is_rising, static_cast<int>(does));
        CHECK(result_with(disturber, victim, is_rising, does) == ram_failed);
      }
    }
  }
}

TEST_CASE("a chip that fails its test runs no program, lights its LED and lets go of the supply after 5 s",
          "[H-27][SB-1.1][SB-4.4]") {
  for (const bool is_ram : {false, true}) {
    CAPTURE(is_ram);
    Chip chip;
    bool has_spoken = false;
    chip.board->on_speak([&](std::uint8_t, Time) { has_spoken = true; });
    chip.board->upset(is_ram ? stuck_bit(0x2000, 3, true) : flash_bit(0x7000, 3));
    chip.board->power(true, chip.now);
    chip.run(1ms);
    CHECK(chip.board->pins().power_latch);
    chip.run(4979ms);
    CHECK(chip.board->pins().power_latch);
    chip.run(40ms);
    CHECK_FALSE(chip.board->pins().power_latch);
    chip.run(5s);
    CHECK(chip.board->ram(tccr0b) == 0);
    CHECK_FALSE(chip.board->pins().power_latch);
    CHECK(chip.board->pins().status_led);
    CHECK(chip.is_safe());
    CHECK(chip.board->statistics().resets == 0);
    CHECK_FALSE(has_spoken);
    CHECK(chip.board->eeprom() == std::vector<std::uint8_t>(4096, 0xFF));
  }
}

TEST_CASE("a guard that is overwritten is an event", "[H-22]") {
  const unsigned end = load_avr_image(image()).address_of("_end").value();
  for (const unsigned offset : {0U, 3U, 7U}) {
    Chip chip;
    chip.board->power(true, chip.now);
    chip.run(500ms);
    CHECK(chip.logged(41, 0) == 0);
    chip.board->upset(stuck_bit(end + offset, 0, false));
    chip.run(500ms);
    CHECK(chip.logged(41, 0) == 1);
  }
}

TEST_CASE("three watchdog resets within 10 s are logged as a loop, a third after 10.3 s is not", "[H-25]") {
  for (const bool is_near_miss : {false, true}) {
    CAPTURE(is_near_miss);
    Chip chip;
    chip.board->power(true, chip.now);
    chip.run(1s);
    chip.board->reset(ResetKind::watchdog, chip.now);
    chip.run(4s);
    chip.board->reset(ResetKind::brown_out, chip.now);
    chip.run(is_near_miss ? 6300ms : 6000ms);
    CHECK(chip.logged(34, 0) == 0);
    chip.board->reset(ResetKind::watchdog, chip.now);
    chip.run(1s);
    CHECK(chip.logged(34, 0) == (is_near_miss ? 0 : 1));
  }
}

TEST_CASE("a loop of resets is over after a power cycle, but not after a reset by hand", "[H-25]") {
  Chip chip;
  chip.board->power(true, chip.now);
  for (int i = 0; i < 3; ++i) {
    chip.run(1s);
    chip.board->reset(ResetKind::watchdog, chip.now);
  }
  chip.run(1s);
  CHECK(chip.logged(34, 0) == 1);
  chip.board->reset(ResetKind::external, chip.now);
  chip.run(1s);
  CHECK(chip.logged(34, 0) == 2);
  chip.turn_off_and_on();
  chip.run(1s);
  CHECK(chip.logged(34, 0) == 2);
}

TEST_CASE("the RAM test leaves nothing but the bytes it retains, and the guard", "[H-25][H-27]") {
  Chip chip;
  chip.board->power(true, chip.now);
  chip.run(300ms);
  const unsigned end = load_avr_image(image()).address_of("_end").value();
  for (unsigned address = end; address < end + 16; ++address) {
    CHECK(unsigned{chip.board->ram(static_cast<std::uint16_t>(address))} == 0xA9);
  }
  const unsigned low_water = chip.board->stack_low_water().value();
  CHECK(low_water > 0x3E00);
  CHECK(low_water < 0x40F0);
  CHECK(unsigned{chip.board->ram(0x2000)} == 0xF0);
}

}  // namespace simulation
