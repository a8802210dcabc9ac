#include "spm/settings.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace spm;

TEST_CASE("every setting takes the ends of its range and nothing beyond, and keeps what it had", "[H-21][SB-0A.2]") {
  for (std::uint8_t i = 0; i < setting_count; ++i) {
    const auto setting = static_cast<Setting>(i);
    const SettingRange range = range_of(setting);
    CAPTURE(int(i));
    Settings settings;
    CHECK(settings[setting] == range.initial);
    CHECK(range.least <= range.initial);
    CHECK(range.initial <= range.most);
    CHECK(settings.set(setting, range.most));
    CHECK(settings[setting] == range.most);
    CHECK_FALSE(settings.set(setting, static_cast<std::uint16_t>(range.most + 1)));
    CHECK_FALSE(settings.set(setting, 65535));
    CHECK(settings[setting] == range.most);
    CHECK(settings.set(setting, range.least));
    CHECK(settings[setting] == range.least);
    if (range.least > 0) {
      CHECK_FALSE(settings.set(setting, static_cast<std::uint16_t>(range.least - 1)));
      CHECK_FALSE(settings.set(setting, 0));
    }
    CHECK(settings[setting] == range.least);
    for (std::uint8_t other = 0; other < setting_count; ++other) {
      if (other != i) {
        CHECK(settings[static_cast<Setting>(other)] == range_of(static_cast<Setting>(other)).initial);
      }
    }
  }
}

TEST_CASE("what goes onto the bus keeps to the document's ranges", "[SB-0A.2]") {
  CHECK(range_of(Setting::speed_button_sensitivity).least == 1);
  CHECK(range_of(Setting::speed_button_sensitivity).most == 10);
  CHECK(range_of(Setting::joystick_switch_threshold).least == 1);
  CHECK(range_of(Setting::joystick_switch_threshold).most == 100);
  CHECK(range_of(Setting::speedo_option).most == 1);
  CHECK(range_of(Setting::click_on_keypress).most == 1);
}

TEST_CASE("the defaults are those of the requirements", "[SB-00.8][SB-01.3][SB-2.16][SB-4.2][SB-0A.2]") {
  const Settings settings;
  CHECK(settings[Setting::deadband] == 30);
  CHECK(settings[Setting::limp_maximum] == 400);
  CHECK(settings[Setting::sleep_timeout] == 15);
  CHECK(settings[Setting::lock_mode_enable] == 1);
  CHECK(settings[Setting::speedo_option] == 1);
  CHECK(settings[Setting::speed_button_sensitivity] == 5);
  CHECK(settings[Setting::joystick_switch_threshold] == 39);
}

TEST_CASE("no emergency rate that may be set takes longer than 1500 ms from full speed", "[SB-2.17][H-21]") {
  CHECK(1000000 / range_of(Setting::emergency_deceleration).least <= 1500);
}

}  // namespace
