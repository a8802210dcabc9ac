// The supply fails while the flashed image writes its EEPROM, and comes back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "simulation/board/avr_board.hpp"
#include "simulation/world.hpp"

namespace simulation {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t log_at = 2048;
constexpr std::size_t places = 256;

// The image tests itself for so long before it begins.
constexpr Time self_test = 225ms;
constexpr Time until_start_is_written = self_test + 250ms;

std::string image() {
  return std::string(PILOTFISH_IMAGE_DIR) + "/spm.elf";
}

// The record's bytes, judged without a line of the product.
unsigned crc8(const std::uint8_t* bytes, int count) {
  unsigned crc = 0;
  for (int i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x80U) != 0 ? (crc << 1 & 0xFFU) ^ 0x07U : crc << 1;
    }
  }
  return crc;
}

Bytes record(const Bytes& eeprom, std::size_t place) {
  const auto begin = eeprom.begin() + static_cast<std::ptrdiff_t>(log_at + 8 * place);
  return {begin, begin + 8};
}

bool is_record(const Bytes& bytes) {
  return bytes[0] != 0xFF && bytes[0] != 0 && bytes[7] == crc8(bytes.data(), 7);
}

// A ring of old records: places 0 to 99 of lap 1, all others of lap 0, so the next one replaces that at 100.
Bytes old_log() {
  Bytes eeprom(4096, 0xFF);
  for (std::size_t place = 0; place < places; ++place) {
    std::uint8_t bytes[8] = {6, 0, place < 100 ? std::uint8_t{1} : std::uint8_t{0}, 9, 0, 41, 0, 0};
    bytes[7] = static_cast<std::uint8_t>(crc8(bytes, 7));
    std::copy(bytes, bytes + 8, eeprom.begin() + static_cast<std::ptrdiff_t>(log_at + 8 * place));
  }
  return eeprom;
}

struct Chip {
  explicit Chip(const Bytes& eeprom) : board(make_avr_board({.image = image()})) {
    board->set_eeprom(eeprom);
    board->on_speak([this](std::uint8_t, Time) { has_spoken = true; });
  }
  void run(Time span) {
    const Time limit = now + span;
    while (now < limit) {
      now = board->run_until(limit);
    }
  }
  bool is_safe() const {
    const Pins pins = board->pins();
    return !pins.bridge_enable && pins.left_duty == 0 && pins.right_duty == 0 && !pins.left_brake_release &&
           !pins.right_brake_release;
  }
  std::unique_ptr<SpmBoard> board;
  Time now{};
  bool has_spoken = false;
};

}  // namespace

TEST_CASE("a supply that fails while the start is written costs the oldest record at most, and the next start is whole",
          "[H-20][SB-3.9]") {
  const Bytes before = old_log();
  int torn = 0;
  int written = 0;
  for (Time cut = self_test + 120ms; cut < self_test + 175ms; cut += 370us) {
    CAPTURE(cut.count());
    Chip chip(before);
    chip.board->power(true, chip.now);
    chip.run(cut);
    REQUIRE(chip.is_safe());
    chip.board->power(false, chip.now);
    const Bytes after_cut = chip.board->eeprom();
    const Bytes place = record(after_cut, 100);
    const bool is_old = place == record(before, 100);
    const bool is_new = is_record(place) && place[0] == 1 && place[1] == 0 && place[2] == 1 && place[5] == 42;
    REQUIRE((!is_record(place) || is_old || is_new));
    torn += is_record(place) ? 0 : 1;
    written += is_new ? 1 : 0;

    chip.board->power(true, chip.now);
    chip.run(until_start_is_written);
    REQUIRE(chip.is_safe());
    const Bytes after = chip.board->eeprom();
    const std::size_t next = is_new ? 101 : 100;
    REQUIRE(is_record(record(after, next)));
    REQUIRE(record(after, next)[0] == 1);
    REQUIRE(int(record(after, next)[5]) == (is_new ? 43 : 42));
    for (std::size_t i = 0; i < places; ++i) {
      if (i != next && i != 100) {
        REQUIRE(record(after, i) == record(before, i));
      }
    }
    REQUIRE(Bytes(after.begin(), after.begin() + log_at) == Bytes(log_at, 0xFF));
    REQUIRE(chip.board->statistics().complaints.empty());
    REQUIRE(chip.board->statistics().resets == 0);
    REQUIRE_FALSE(chip.has_spoken);
  }
  CHECK(torn > 50);
  CHECK(written > 10);
}

TEST_CASE("a reset during a write lets it end, and the start after it is written behind", "[H-20][SB-3.9]") {
  for (Time at = self_test + 130ms; at < self_test + 170ms; at += 1700us) {
    CAPTURE(at.count());
    Chip chip(Bytes(4096, 0xFF));
    chip.board->power(true, chip.now);
    chip.run(at);
    chip.board->reset(ResetKind::watchdog, chip.now);
    chip.run(until_start_is_written);
    const Bytes after = chip.board->eeprom();
    const bool is_first_whole = record(after, 0)[1] == 0;
    const std::size_t place = is_first_whole ? 1 : 0;
    REQUIRE(is_record(record(after, place)));
    REQUIRE(int(record(after, place)[0]) == 1);
    REQUIRE(int(record(after, place)[1]) == 1);  // watchdog
    REQUIRE(chip.board->statistics().complaints.empty());
    REQUIRE(chip.is_safe());
  }
}

TEST_CASE("a supply that fails while an event is written in the midst of driving leaves log and chair in order",
          "[H-20]") {
  std::size_t most_written = 0;
  for (Time cut = 2ms; cut < 60ms; cut += 2370us) {
    CAPTURE(cut.count());
    World world(make_avr_board({.image = image()}));
    world.board().set_eeprom(old_log());
    world.remote().start(world.now());
    world.run_for(1s);
    REQUIRE(int(record(world.board().eeprom(), 100)[0]) == 1);
    world.remote().controls.speed = 1022;
    world.run_for(2s);
    REQUIRE(world.board().pins().left_duty > 0);
    world.remote().is_silent = true;  // the link is lost: an event
    world.run_for(62ms + cut);
    REQUIRE(world.board().pins().left_duty > 0);
    world.board().power(false, world.now());
    const Bytes after_cut = world.board().eeprom();
    std::size_t next = 101;  // behind those events that were written to their end
    while (is_record(record(after_cut, next)) && record(after_cut, next)[2] == 1) {
      ++next;
    }
    for (std::size_t place = 0; place < places; ++place) {
      REQUIRE((is_record(record(after_cut, place)) || place == next));
    }
    most_written = std::max(most_written, next - 101);
    world.board().power(true, world.now());
    world.run_for(until_start_is_written);
    const Bytes after = world.board().eeprom();
    REQUIRE(is_record(record(after, next)));
    REQUIRE(int(record(after, next)[0]) == 1);
    REQUIRE(int(record(after, next)[5]) == 43);
    const Pins pins = world.board().pins();
    REQUIRE_FALSE(pins.bridge_enable);
    REQUIRE_FALSE(pins.left_brake_release);
    REQUIRE(world.board().statistics().complaints.empty());
  }
  CHECK(most_written >= 1);
}

TEST_CASE("a confirmed power-down is written to its end before the latch is let go", "[SB-4.3][SB-4.5][H-20]") {
  World world(make_avr_board({.image = image()}));
  world.remote().start(world.now());
  world.run_for(1s);
  world.remote().controls.power_button = true;
  world.run_for(200ms);
  world.remote().controls.power_button = false;
  Time waited{};
  while (world.board().pins().power_latch) {
    world.run_for(1ms);
    waited += 1ms;
    REQUIRE(waited < 300ms);
  }
  const Bytes eeprom = world.board().eeprom();
  const std::vector<int> codes{record(eeprom, 0)[0], record(eeprom, 1)[0], record(eeprom, 2)[0]};
  CHECK(codes == std::vector<int>{1, 5, 6});  // started, power-down asked, powered down
  CHECK(is_record(record(eeprom, 2)));
  const Bytes later = (world.run_for(100ms), world.board().eeprom());
  CHECK(later == eeprom);
}

TEST_CASE("the .eep file is settings that the image takes", "[H-20]") {
  Bytes eeprom(4096, 0xFF);
  std::ifstream file(std::string(PILOTFISH_IMAGE_DIR) + "/spm.eep");
  const auto hex = [](const std::string& line, std::size_t at, std::size_t digits) {
    return std::stoul(line.substr(at, digits), nullptr, 16);
  };
  std::size_t count = 0;
  for (std::string line; std::getline(file, line) && hex(line, 7, 2) == 0;) {
    for (std::size_t i = 0; i < hex(line, 1, 2); ++i) {
      eeprom.at(hex(line, 3, 4) + i) = static_cast<std::uint8_t>(hex(line, 9 + 2 * i, 2));
      ++count;
    }
  }
  REQUIRE(count > 128);
  CHECK(eeprom[0] == 0x00);  // written
  CHECK(eeprom[3] == 0);     // sequence
  CHECK(eeprom[4] == 30);    // deadband
  CHECK(eeprom[128] == 0x00);
  CHECK(eeprom[131] == 255);  // the older one
  CHECK(eeprom[132] == 30);
  Chip chip(eeprom);
  chip.board->power(true, chip.now);
  chip.run(self_test + 300ms);
  const Bytes after = chip.board->eeprom();
  CHECK(int(record(after, 0)[0]) == 1);
  CHECK(record(after, 1) == Bytes(8, 0xFF));  // neither a loss nor a bad copy
  CHECK(Bytes(after.begin(), after.begin() + log_at) == Bytes(eeprom.begin(), eeprom.begin() + log_at));
}

}  // namespace simulation
