#include "spm/settings_block.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace {

using namespace spm;

constexpr std::uint8_t last = settings_size - 1;

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
  return std::string(block.begin(), block.end() - 2);
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
  const SettingsBlock block = make_settings_block(changed());
  CHECK(crc16_of(block) == textbook_crc(message_of(block)));
}

TEST_CASE("a block holds version, count, every value low byte first, and the checksum") {
  const SettingsBlock block = make_settings_block(changed());
  CHECK(block[0] == 1);
  CHECK(block[1] == setting_count);
  CHECK(block[2] == 44);
  CHECK(block[3] == 0);
  const auto full_at = static_cast<std::uint8_t>(2 + 2 * static_cast<int>(Setting::battery_full));
  CHECK(block[full_at] == 0xD3);  // 25555 = 0x63D3
  CHECK(block[static_cast<std::uint8_t>(full_at + 1)] == 0x63);
  SettingsBlock sealed = block;
  seal(sealed);
  CHECK(sealed[last] == block[last]);
  CHECK(sealed[last - 1] == block[last - 1]);
}

TEST_CASE("what was stored comes back", "[H-20]") {
  const LoadedSettings loaded = read_settings(make_settings_block(changed()));
  CHECK_FALSE(loaded.is_lost);
  CHECK(loaded.settings[Setting::deadband] == 44);
  CHECK(loaded.settings[Setting::battery_full] == 25555);
  CHECK(loaded.settings[Setting::joystick_switch_threshold] == 77);
  CHECK(loaded.settings[Setting::acceleration] == 145);
}

TEST_CASE("an erased block is a new board: defaults, and nothing is lost", "[H-20]") {
  SettingsBlock block{};
  for (std::uint8_t& byte : block) {
    byte = 0xFF;
  }
  const LoadedSettings loaded = read_settings(block);
  CHECK_FALSE(loaded.is_lost);
  CHECK(are_defaults(loaded.settings));
}

TEST_CASE("any flipped bit gives the defaults, all of them, and says so", "[H-20]") {
  const SettingsBlock good = make_settings_block(changed());
  for (std::uint8_t at = 0; at < settings_size; ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      SettingsBlock block = good;
      block[at] = static_cast<std::uint8_t>(block[at] ^ 1U << bit);
      const LoadedSettings loaded = read_settings(block);
      CAPTURE(int(at), bit);
      REQUIRE(loaded.is_lost);
      REQUIRE(are_defaults(loaded.settings));
    }
  }
}

TEST_CASE("a write cut short anywhere gives the old settings, the new ones or the defaults, never a mix", "[H-20]") {
  const SettingsBlock old_block = make_settings_block(Settings());
  const SettingsBlock new_block = make_settings_block(changed());
  for (std::uint8_t written = 0; written <= settings_size; ++written) {
    for (const int torn : {-1, 0x00, 0xFF, 0x55}) {  // what the byte being written holds, -1 = the old one
      SettingsBlock block = old_block;
      for (std::uint8_t i = 0; i < written; ++i) {
        block[i] = new_block[i];
      }
      if (torn >= 0 && written < settings_size) {
        block[written] = static_cast<std::uint8_t>(torn);
      }
      const LoadedSettings loaded = read_settings(block);
      const bool is_new = loaded.settings[Setting::deadband] == 44 && loaded.settings[Setting::battery_full] == 25555 &&
                          loaded.settings[Setting::joystick_switch_threshold] == 77;
      CAPTURE(int(written), torn);
      CHECK((are_defaults(loaded.settings) || is_new));
    }
  }
}

TEST_CASE("a block of zeros is a loss", "[H-20]") {
  CHECK(read_settings(SettingsBlock{}).is_lost);
}

TEST_CASE("a sound block of another version or length is a loss", "[H-20]") {
  SettingsBlock version = make_settings_block(changed());
  version[0] = 2;
  seal(version);
  CHECK(read_settings(version).is_lost);
  SettingsBlock count = make_settings_block(changed());
  count[1] = static_cast<std::uint8_t>(setting_count + 1);
  seal(count);
  CHECK(read_settings(count).is_lost);
}

TEST_CASE("a sound block with one value out of its range is a loss", "[H-20][H-21]") {
  for (std::uint8_t i = 0; i < setting_count; ++i) {
    SettingsBlock block = make_settings_block(changed());
    const unsigned beyond = range_of(static_cast<Setting>(i)).most + 1U;
    block[static_cast<std::uint8_t>(2 + 2 * i)] = static_cast<std::uint8_t>(beyond % 256);
    block[static_cast<std::uint8_t>(3 + 2 * i)] = static_cast<std::uint8_t>(beyond / 256);
    seal(block);
    const LoadedSettings loaded = read_settings(block);
    CAPTURE(int(i));
    CHECK(loaded.is_lost);
    CHECK(are_defaults(loaded.settings));
  }
}

}  // namespace
