#include "spm/storage.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "drivers/host/machine.hpp"
#include "spm/events.hpp"
#include "spm/firmware.hpp"
#include "tests/support/eeprom.hpp"

namespace {

using namespace support;
using spm::Setting;
using spm::Settings;

Settings settings_with(std::uint16_t deadband, std::uint16_t battery_full) {
  Settings settings;
  REQUIRE(settings.set(Setting::deadband, deadband));
  REQUIRE(settings.set(Setting::battery_full, battery_full));
  return settings;
}

bool are_same(const Settings& one, const Settings& other) {
  for (std::uint8_t i = 0; i < spm::setting_count; ++i) {
    if (one[static_cast<Setting>(i)] != other[static_cast<Setting>(i)]) {
      return false;
    }
  }
  return true;
}

void store(Eeprom& eeprom, const Settings& settings) {
  Started module(eeprom);
  REQUIRE(module.storage.store(settings));
  module.write_all(eeprom);
}

TEST_CASE("settings that were stored are there after the next start, copy by copy", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  store(eeprom, settings_with(41, 25001));
  CHECK(eeprom[0] == 0x00);
  CHECK(eeprom[3] == 1);   // sequence
  CHECK(eeprom[4] == 41);  // deadband
  CHECK(eeprom[128] == 0xFF);
  CHECK(are_same(Started(eeprom).loaded.settings, settings_with(41, 25001)));
  store(eeprom, settings_with(42, 25002));
  CHECK(eeprom[4] == 41);
  CHECK(eeprom[128] == 0x00);
  CHECK(eeprom[131] == 2);
  CHECK(eeprom[132] == 42);
  CHECK(are_same(Started(eeprom).loaded.settings, settings_with(42, 25002)));
  store(eeprom, settings_with(43, 25003));
  CHECK(eeprom[3] == 3);
  CHECK(eeprom[4] == 43);
  CHECK(eeprom[132] == 42);
  CHECK(are_same(Started(eeprom).loaded.settings, settings_with(43, 25003)));
}

TEST_CASE("writing goes byte by byte, the mark first and last", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  store(eeprom, Settings());
  Started module(eeprom);
  REQUIRE(module.storage.store(settings_with(44, 25555)));
  CHECK(module.storage.is_pending());
  CHECK_FALSE(module.storage.store(Settings()));  // one after the other
  const auto writes = module.write_all(eeprom);
  REQUIRE(writes.size() == spm::settings_size + 1U);
  CHECK(writes.front().address == 128);
  CHECK(writes.front().value == 0xFF);
  CHECK(writes.back().address == 128);
  CHECK(writes.back().value == 0x00);
  CHECK_FALSE(module.storage.is_pending());
  CHECK(module.storage.store(Settings()));
}

TEST_CASE("a cut at any byte of settings leaves the old ones or the new ones, and the log as it was", "[H-20]") {
  const Settings old_settings = settings_with(41, 25001);
  const Settings new_settings = settings_with(99, 29999);
  Eeprom once = erased_eeprom();
  {
    Started module(once);
    module.note(1);
    module.write_all(once);
  }
  Eeprom blank = once;
  store(once, old_settings);
  Eeprom twice = once;  // both copies in use
  store(twice, settings_with(77, 27777));
  store(twice, old_settings);
  Eeprom thrice = twice;  // the older one behind
  store(thrice, old_settings);

  std::uint32_t seed = 7;
  for (const Eeprom& before : {blank, once, twice, thrice}) {
    const bool is_blank = before[0] == 0xFF;
    Started writer(before);
    REQUIRE(writer.storage.store(new_settings));
    Eeprom reached = before;
    bool was_new = false;
    for (auto write = writer.storage.next_write(); write; write = writer.storage.next_write()) {
      for (const std::uint8_t outcome : torn(reached[write->address], write->value, seed)) {
        Eeprom cut = reached;
        cut[write->address] = outcome;
        Started next(cut);
        const bool is_old = are_same(next.loaded.settings, is_blank ? Settings() : old_settings);
        const bool is_new = are_same(next.loaded.settings, new_settings);
        REQUIRE((is_old || is_new));
        REQUIRE_FALSE(next.loaded.is_lost);
        REQUIRE_FALSE(next.loaded.is_copy_bad);
        REQUIRE(next.storage.log().starts() == 2);
        // A second cut, in the writing that makes up for it, is not worse: half of it is done.
        REQUIRE(next.storage.store(new_settings));
        for (int i = 0; i < 20; ++i) {
          const auto again = next.storage.next_write();
          cut[again->address] = again->value;
        }
        Started third(cut);
        const Settings then = third.loaded.settings;
        REQUIRE((are_same(then, new_settings) || are_same(then, is_blank ? Settings() : old_settings)));
        REQUIRE_FALSE(third.loaded.is_lost);
        REQUIRE(third.storage.store(new_settings));
        third.write_all(cut);
        REQUIRE(are_same(Started(cut).loaded.settings, new_settings));
      }
      reached[write->address] = write->value;
      was_new = are_same(Started(reached).loaded.settings, new_settings);
    }
    CHECK(was_new);
  }
}

TEST_CASE("a copy that is bad, torn or not there is written anew from the other", "[H-20]") {
  Eeprom both = erased_eeprom();
  store(both, settings_with(41, 25001));
  store(both, settings_with(42, 25002));
  Eeprom bad_first = both;
  bad_first[20] ^= 0x40;
  Eeprom bad_second = both;
  bad_second[150] ^= 0x40;
  Eeprom torn_second = both;
  torn_second[128] = 0xFF;
  Eeprom only_second = both;
  std::fill(only_second.begin(), only_second.begin() + 64, std::uint8_t{0xFF});
  for (const Eeprom& before : {bad_first, bad_second, torn_second, only_second}) {
    Eeprom eeprom = before;
    Started module(eeprom);
    const Settings used = module.loaded.settings;
    const unsigned rewritten = module.loaded.next_copy;
    CHECK(module.storage.is_storing());
    CHECK_FALSE(module.loaded.is_lost);
    const auto writes = module.write_all(eeprom);
    REQUIRE(writes.size() == spm::settings_size + 1U);
    CHECK(writes.front().address == 128 * rewritten);
    CHECK(writes.front().value == 0xFF);
    CHECK(eeprom[4] == eeprom[132]);      // deadband
    CHECK(eeprom[128 * rewritten] == 0);  // the mark
    CHECK(std::equal(eeprom.begin() + 4, eeprom.begin() + 52, eeprom.begin() + 132));
    Started next(eeprom);
    CHECK_FALSE(next.storage.is_storing());
    CHECK_FALSE(next.loaded.is_copy_bad);
    CHECK(are_same(next.loaded.settings, used));
  }
}

TEST_CASE("settings that are stored while a copy is written anew go first, and are whole", "[H-20]") {
  for (int bytes = 0; bytes <= spm::settings_size; ++bytes) {
    Eeprom eeprom = erased_eeprom();
    store(eeprom, settings_with(41, 25001));
    Started module(eeprom);
    for (int i = 0; i < bytes; ++i) {
      const auto write = module.storage.next_write();
      eeprom[write->address] = write->value;
    }
    REQUIRE(module.storage.store(settings_with(42, 25002)));
    CHECK_FALSE(module.storage.store(Settings()));
    module.write_all(eeprom);
    CHECK(are_same(Started(eeprom).loaded.settings, settings_with(42, 25002)));
    CHECK(eeprom[4] == 41);
  }
}

TEST_CASE("two sound copies, none at all, or none that is sound: nothing is written at the start", "[H-20]") {
  Eeprom both = erased_eeprom();
  store(both, settings_with(41, 25001));
  store(both, settings_with(42, 25002));
  Eeprom lost = both;
  lost[20] ^= 0x40;
  lost[150] ^= 0x40;
  for (const Eeprom& before : {both, lost, erased_eeprom()}) {
    Eeprom eeprom = before;
    Started module(eeprom);
    CHECK_FALSE(module.storage.is_storing());
    CHECK(module.write_all(eeprom).empty());
  }
}

TEST_CASE("two writings between two starts go to different copies", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  REQUIRE(module.storage.store(settings_with(41, 25001)));
  module.write_all(eeprom);
  REQUIRE(module.storage.store(settings_with(42, 25002)));
  module.write_all(eeprom);
  CHECK(eeprom[4] == 41);
  CHECK(eeprom[131] == 2);
  CHECK(eeprom[132] == 42);
  CHECK(are_same(Started(eeprom).loaded.settings, settings_with(42, 25002)));
}

TEST_CASE("settings go before events") {
  Eeprom eeprom = erased_eeprom();
  Started module(eeprom);
  module.note(1);
  REQUIRE(module.storage.store(Settings()));
  const auto writes = module.write_all(eeprom);
  CHECK(writes.front().address == 0);
  CHECK(writes.back().address == 2048);
  CHECK(writes.size() == spm::settings_size + 1U + 9U);
}

// ---- the whole firmware on the host's drivers

struct Module {
  explicit Module(drivers::watchdog::ResetCause cause = drivers::watchdog::ResetCause::power_on,
                  const Eeprom& eeprom = erased_eeprom()) {
    machine.reset_cause = cause;
    machine.eeprom = eeprom;
    machine.analog_raw.fill(512);
    machine.analog_raw[static_cast<unsigned>(drivers::analog::Channel::brake_coils)] = 0;
    drivers::host::select(machine);
    firmware.start();
  }
  void run_ms(int count) {
    for (int i = 0; i < count; ++i) {
      machine.now = machine.now + base::Millis(1);
      firmware.pass();
    }
  }
  spm::RecordBytes record(unsigned place) const { return place_in(machine.eeprom, place); }

  drivers::host::Machine machine;
  spm::Firmware firmware;
};

TEST_CASE("the log says why the module started", "[SB-3.9]") {
  using drivers::watchdog::ResetCause;
  const auto argument = [](ResetCause cause) {
    Module module(cause);
    module.run_ms(200);
    REQUIRE(module.record(0)[0] == 1);
    return int(module.record(0)[1]);
  };
  CHECK(argument(ResetCause::power_on) == 0);
  CHECK(argument(ResetCause::watchdog) == 1);
  CHECK(argument(ResetCause::brown_out) == 2);
  CHECK(argument(ResetCause::external) == 3);
}

TEST_CASE("the start is written 165 ms after it, one byte in four milliseconds", "[H-20]") {
  Module module;
  module.run_ms(127);
  CHECK(module.machine.eeprom == erased_eeprom());
  module.run_ms(1 + 2 * 4);
  CHECK(module.record(0)[1] == 0x00);  // argument
  CHECK(module.record(0)[0] == 0xFF);
  module.run_ms(7 * 4);
  CHECK(module.record(0)[0] == 1);
  CHECK(module.record(0)[5] == 1);  // the first start
}

TEST_CASE("settings from the EEPROM are used", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  store(eeprom, settings_with(55, 25001));
  const Module module(drivers::watchdog::ResetCause::power_on, eeprom);
  CHECK(module.firmware.core().settings()[Setting::deadband] == 55);
}

TEST_CASE("one bad copy is logged and nothing more; two are settings lost, and LIMP", "[H-20]") {
  Eeprom eeprom = erased_eeprom();
  store(eeprom, settings_with(55, 25001));
  store(eeprom, settings_with(56, 25002));
  eeprom[4] ^= 0x01;
  Module one(drivers::watchdog::ResetCause::power_on, eeprom);
  one.run_ms(300);
  CHECK(one.firmware.core().settings()[Setting::deadband] == 56);
  CHECK_FALSE(one.firmware.core().faults().is_limping);
  one.run_ms(280);  // the copy goes first
  CHECK(int(one.machine.eeprom[4]) == 56);
  CHECK(one.record(0)[0] == 1);
  CHECK(one.record(1)[0] == 26);
  eeprom[132] ^= 0x01;
  Module both(drivers::watchdog::ResetCause::power_on, eeprom);
  both.run_ms(300);
  CHECK(both.firmware.core().settings()[Setting::deadband] == 30);
  CHECK(both.firmware.core().faults().is_limping);
  CHECK(both.record(1)[0] == 25);
}

}  // namespace
