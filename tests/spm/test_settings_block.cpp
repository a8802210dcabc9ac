#include "spm/settings_block.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace {

using namespace spm;

constexpr std::uint8_t last = settings_size - 1;

SettingsBlock erased() {
  SettingsBlock block{};
  for (std::uint8_t& byte : block) {
    byte = 0xFF;
  }
  return block;
}

bool are_defaults(const Settings& settings) {
  for (std::uint8_t i = 0; i < setting_count; ++i) {
    if (settings[static_cast<Setting>(i)] != range_of(static_cast<Setting>(i)).initial) {
      return false;
    }
  }
  return true;
}

Settings changed() {
  Settings settings;
  settings.set(Setting::deadband, 44);
  settings.set(Setting::battery_full, 25555);
  settings.set(Setting::joystick_switch_threshold, 77);
  return settings;
}

// The textbook's way, a bit at a time with the message shifted through, so that it shares nothing with the product.
unsigned textbook_crc(const std::string& message) {
  unsigned crc = 0xFFFF;
  for (const char character : message) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned top = crc >> 15 & 1U;
      const unsigned in = static_cast<unsigned>(static_cast<unsigned char>(character)) >> bit & 1U;
      crc = (crc << 1 & 0xFFFFU) ^ (top != in ? 0x1021U : 0U);
    }
  }
  return crc;
}

std::string message_of(const SettingsBlock& block) {
  return std::string(block.begin() + 1, block.end() - 2);
}

void seal(SettingsBlock& block) {
  const unsigned crc = textbook_crc(message_of(block));
  block[last - 1] = static_cast<std::uint8_t>(crc % 256);
  block[last] = static_cast<std::uint8_t>(crc / 256);
}

TEST_CASE("the checksum is CRC-16/CCITT-FALSE") {
  std::uint16_t crc = 0xFFFF;
  for (const char character : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    crc = crc16_step(crc, static_cast<std::uint8_t>(character));
  }
  CHECK(crc == 0x29B1);
  CHECK(textbook_crc("123456789") == 0x29B1);
  const SettingsBlock block = make_settings_block(changed(), 7);
  CHECK(crc16_of(block) == textbook_crc(message_of(block)));
}

TEST_CASE("a block holds mark, version, count, sequence, every value low byte first, and the checksum") {
  const SettingsBlock block = make_settings_block(changed(), 0xA7);
  CHECK(block[0] == 0x00);
  CHECK(block[1] == 2);
  CHECK(block[2] == setting_count);
  CHECK(block[3] == 0xA7);
  CHECK(block[4] == 44);
  CHECK(block[5] == 0);
  const auto full_at = static_cast<std::uint8_t>(4 + 2 * static_cast<int>(Setting::battery_full));
  CHECK(block[full_at] == 0xD3);  // 25555 = 0x63D3
  CHECK(block[static_cast<std::uint8_t>(full_at + 1)] == 0x63);
  SettingsBlock sealed = block;
  seal(sealed);
  CHECK(sealed[last] == block[last]);
  CHECK(sealed[last - 1] == block[last - 1]);
}

TEST_CASE("the copies lie at 0 and 128") {
  CHECK(address_of_copy(0) == 0);
  CHECK(address_of_copy(1) == 128);
}

TEST_CASE("what was stored comes back, from either copy", "[H-20]") {
  const SettingsBlock block = make_settings_block(changed(), 3);
  for (const bool is_first : {true, false}) {
    const LoadedSettings loaded = is_first ? read_settings(block, erased()) : read_settings(erased(), block);
    CHECK_FALSE(loaded.is_lost);
    CHECK_FALSE(loaded.is_copy_bad);
    CHECK(loaded.settings[Setting::deadband] == 44);
    CHECK(loaded.settings[Setting::battery_full] == 25555);
    CHECK(loaded.settings[Setting::joystick_switch_threshold] == 77);
    CHECK(loaded.settings[Setting::acceleration] == 145);
    CHECK(loaded.sequence == 3);
    CHECK(int(loaded.next_copy) == (is_first ? 1 : 0));
  }
}

TEST_CASE("of two sound copies the newer one counts, across the sequence's wrap too", "[H-20]") {
  const auto deadband = [](std::uint8_t first, std::uint8_t second) {
    return read_settings(make_settings_block(Settings(), first), make_settings_block(changed(), second))
        .settings[Setting::deadband];
  };
  CHECK(deadband(0, 1) == 44);
  CHECK(deadband(1, 0) == 30);
  CHECK(deadband(255, 0) == 44);
  CHECK(deadband(0, 255) == 30);
  CHECK(deadband(127, 128) == 44);
  CHECK(deadband(0, 127) == 44);
  CHECK(deadband(0, 128) == 30);
}

TEST_CASE("the next write goes to the copy that is not in use", "[H-20]") {
  const SettingsBlock old_block = make_settings_block(Settings(), 8);
  const SettingsBlock new_block = make_settings_block(changed(), 9);
  CHECK(int(read_settings(new_block, old_block).next_copy) == 1);
  CHECK(int(read_settings(old_block, new_block).next_copy) == 0);
  CHECK(int(read_settings(old_block, SettingsBlock{}).next_copy) == 1);
}

TEST_CASE("two erased copies are a new board: defaults, and nothing is lost", "[H-20]") {
  const LoadedSettings loaded = read_settings(erased(), erased());
  CHECK_FALSE(loaded.is_lost);
  CHECK_FALSE(loaded.is_copy_bad);
  CHECK(are_defaults(loaded.settings));
}

TEST_CASE("any flipped bit of the only copy gives the defaults, all of them, and says so", "[H-20]") {
  const SettingsBlock good = make_settings_block(changed(), 1);
  for (std::uint8_t at = 1; at < settings_size; ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      SettingsBlock block = good;
      block[at] = static_cast<std::uint8_t>(block[at] ^ 1U << bit);
      const LoadedSettings loaded = read_settings(block, erased());
      CAPTURE(int(at), bit);
      REQUIRE(loaded.is_lost);
      REQUIRE(are_defaults(loaded.settings));
    }
  }
}

TEST_CASE("any flipped bit of the newer copy gives the older one, whole, and says so without a loss", "[H-20]") {
  const SettingsBlock good = make_settings_block(changed(), 1);
  const SettingsBlock older = make_settings_block(Settings(), 0);
  for (std::uint8_t at = 1; at < settings_size; ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      SettingsBlock block = good;
      block[at] = static_cast<std::uint8_t>(block[at] ^ 1U << bit);
      const LoadedSettings loaded = read_settings(older, block);
      CAPTURE(int(at), bit);
      REQUIRE_FALSE(loaded.is_lost);
      REQUIRE(loaded.is_copy_bad);
      REQUIRE(are_defaults(loaded.settings));
      REQUIRE(int(loaded.next_copy) == 1);
    }
  }
}

TEST_CASE("a mark with flipped bits still stands for a whole block", "[H-20]") {
  SettingsBlock block = make_settings_block(changed(), 1);
  for (unsigned mark = 0; mark < 0xFF; ++mark) {
    block[0] = static_cast<std::uint8_t>(mark);
    REQUIRE(read_settings(block, erased()).settings[Setting::deadband] == 44);
  }
  block[0] = 0xFF;
  CHECK(are_defaults(read_settings(block, erased()).settings));
  CHECK_FALSE(read_settings(block, erased()).is_lost);
}

TEST_CASE("two blocks of zeros are a loss", "[H-20]") {
  CHECK(read_settings(SettingsBlock{}, SettingsBlock{}).is_lost);
}

TEST_CASE("a sound block of another version or length is a loss", "[H-20]") {
  SettingsBlock version = make_settings_block(changed(), 1);
  version[1] = 1;
  seal(version);
  CHECK(read_settings(version, erased()).is_lost);
  SettingsBlock count = make_settings_block(changed(), 1);
  count[2] = static_cast<std::uint8_t>(setting_count + 1);
  seal(count);
  CHECK(read_settings(count, erased()).is_lost);
}

TEST_CASE("a sound block with one value out of its range is a loss", "[H-20][H-21]") {
  for (std::uint8_t i = 0; i < setting_count; ++i) {
    SettingsBlock block = make_settings_block(changed(), 1);
    const unsigned beyond = range_of(static_cast<Setting>(i)).most + 1U;
    block[static_cast<std::uint8_t>(4 + 2 * i)] = static_cast<std::uint8_t>(beyond % 256);
    block[static_cast<std::uint8_t>(5 + 2 * i)] = static_cast<std::uint8_t>(beyond / 256);
    seal(block);
    const LoadedSettings loaded = read_settings(block, erased());
    CAPTURE(int(i));
    CHECK(loaded.is_lost);
    CHECK(are_defaults(loaded.settings));
  }
}

}  // namespace
