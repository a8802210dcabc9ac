// spm: settings, their ranges, and the block in which they are stored.
#include "spm/settings.hpp"

#include "spm/settings_block.hpp"
#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"
#include "tests/vectors/settings.hpp"

namespace vectors {

using spm::Setting;
using spm::Settings;
using spm::SettingsBlock;

Settings any_extremes(Random& random) {
  Settings settings;
  for (uint8_t i = 0; i < spm::setting_count; ++i) {
    const spm::SettingRange range = spm::range_of(static_cast<Setting>(i));
    const uint16_t choices[] = {range.initial, range.least, range.most};
    settings.set(static_cast<Setting>(i), random.any_of(choices));
  }
  return settings;
}

namespace {

Settings any_settings(Random& random) {
  Settings settings;
  for (uint8_t i = 0; i < spm::setting_count; ++i) {
    const spm::SettingRange range = spm::range_of(static_cast<Setting>(i));
    const uint16_t above = random.below(static_cast<uint16_t>(range.most - range.least + 1));
    settings.set(static_cast<Setting>(i), static_cast<uint16_t>(range.least + above));
  }
  return settings;
}

void add_settings(Record& record, const Settings& settings) {
  for (uint8_t i = 0; i < spm::setting_count; ++i) {
    record.add(settings[static_cast<Setting>(i)]);
  }
}

void add_loaded(Record& record, const SettingsBlock& block) {
  const spm::LoadedSettings loaded = spm::read_settings(block, spm::make_settings_block(Settings(), 200));
  record.add(loaded.is_copy_bad);
  record.add(loaded.next_copy);
  add_settings(record, loaded.settings);
}

bool is_lost(const SettingsBlock& block) {
  return spm::read_settings(block, block).is_lost;
}

uint16_t crc16_of_text(const char* text) {
  uint16_t crc = 0xFFFF;
  for (; *text != '\0'; ++text) {
    crc = spm::crc16_step(crc, static_cast<uint8_t>(*text));
  }
  return crc;
}

// A block that is sound but for one value, which the settings themselves would not have taken.
SettingsBlock block_with(Setting setting, uint16_t value) {
  SettingsBlock block = spm::make_settings_block(Settings(), 201);
  const uint8_t place = static_cast<uint8_t>(4 + 2 * static_cast<uint8_t>(setting));
  block[place] = static_cast<uint8_t>(value & 0xFF);
  block[static_cast<uint8_t>(place + 1)] = static_cast<uint8_t>(value >> 8);
  const uint16_t crc = spm::crc16_of(block);
  block[spm::settings_size - 2] = static_cast<uint8_t>(crc & 0xFF);
  block[spm::settings_size - 1] = static_cast<uint8_t>(crc >> 8);
  return block;
}

}  // namespace

void setting_ranges(Record& record) {
  for (uint8_t i = 0; i < spm::setting_count; ++i) {
    const Setting setting = static_cast<Setting>(i);
    const spm::SettingRange range = spm::range_of(setting);
    record.add(range.initial);
    record.add(range.least);
    record.add(range.most);
    Settings settings;
    const uint16_t tries[] = {0,
                              static_cast<uint16_t>(range.least - 1),
                              range.least,
                              range.most,
                              static_cast<uint16_t>(range.most + 1),
                              32767,
                              32768,
                              65535};
    for (const uint16_t value : tries) {
      record.add(settings.set(setting, value));
      record.add(settings[setting]);
    }
  }
  Settings settings;
  record.known(settings.set(Setting::deadband, 9), 0);
  record.known(settings.set(Setting::deadband, 10), 1);
  record.known(settings.set(Setting::deadband, 101), 0);
  record.known(settings[Setting::deadband], 10);
  record.known(settings.set(Setting::battery_full, 30001), 0);
  record.known(settings[Setting::battery_full], 25300);
}

void settings_block(Record& record) {
  const SettingsBlock shipped = spm::make_settings_block(Settings(), 0);
  for (uint8_t i = 0; i < spm::settings_size; ++i) {
    record.add(shipped[i]);
    SettingsBlock torn = shipped;
    torn[i] = static_cast<uint8_t>(torn[i] ^ 0x80);
    add_loaded(record, torn);
    torn[i] = 0xFF;
    add_loaded(record, torn);
  }
  Random random(9);
  for (uint16_t i = 0; i < 100; ++i) {
    add_loaded(record, spm::make_settings_block(any_settings(random), static_cast<uint8_t>(i)));
    add_loaded(record, spm::make_settings_block(any_extremes(random), static_cast<uint8_t>(i)));
    const Setting setting = static_cast<Setting>(random.below(spm::setting_count));
    add_loaded(record, block_with(setting, random.word()));
  }
  SettingsBlock erased;
  for (uint8_t& byte : erased) {
    byte = 0xFF;
  }
  add_loaded(record, erased);

  record.known(crc16_of_text("123456789"), 0x29B1);
  record.known(crc16_of_text("A"), 0xB915);
  record.known(crc16_of_text(""), 0xFFFF);
  record.known(shipped[0], 0);
  record.known(shipped[1], 2);
  record.known(shipped[4], 30);  // the deadband
  record.known(shipped[5], 0);
  record.known(shipped[6] | shipped[7] << 8, 475);  // the stick's travel
  record.known(is_lost(shipped), 0);
  record.known(is_lost(erased), 0);
  record.known(spm::read_settings(block_with(Setting::deadband, 100), shipped).settings[Setting::deadband], 30);
  record.known(spm::read_settings(block_with(Setting::deadband, 100), erased).settings[Setting::deadband], 100);
  record.known(is_lost(block_with(Setting::deadband, 101)), 1);
}

}  // namespace vectors
