// The judge of `pilotfish powercut` must be able to say no: each of its reasons by an EEPROM made by hand.
#include "simulation/powercut/judge.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "simulation/powercut/wear.hpp"

namespace simulation::powercut {
namespace {

using eeprom::Bytes;

constexpr std::size_t second = 128;

void put(Bytes& contents, std::size_t at, const Bytes& bytes) {
  std::copy(bytes.begin(), bytes.end(), contents.begin() + static_cast<std::ptrdiff_t>(at));
}

Bytes values(std::uint8_t sensitivity, std::uint8_t threshold) {
  Bytes values(48, 0x01);
  values[44] = sensitivity;
  values[45] = 0;
  values[46] = threshold;
  values[47] = 0;
  return values;
}

const Bytes old_values = values(3, 20);
const Bytes new_values = values(7, 51);
const Layout layout{2, 24, values(5, 39)};

// Places 0 to 99 of lap 1, the others of lap 0.
Scene scene() {
  Scene scene;
  scene.eeprom = Bytes(4096, 0xFF);
  put(scene.eeprom, 0, eeprom::make_copy(old_values, 2, 5));
  put(scene.eeprom, second, eeprom::make_copy(old_values, 2, 4));
  for (unsigned place = 0; place < 256; ++place) {
    eeprom::write_record(scene.eeprom, {static_cast<std::uint16_t>(place + (place < 100 ? 256 : 0)), 6, 0, 9, 41});
  }
  scene.allowed = {old_values, new_values};
  scene.next_place = 100;
  return scene;
}

Answer answer_with(int sensitivity, int threshold) {
  return {true, false, 0, sensitivity, threshold};
}

// A start that was told as it must be.
Bytes started(const Scene& scene) {
  Bytes after = scene.eeprom;
  eeprom::write_record(after, {356, 1, 0, 0, 42});
  return after;
}

}  // namespace

TEST_CASE("old settings and new ones are safe, a mix of both is not", "[H-20]") {
  const Scene before = scene();
  Bytes after = started(before);
  CHECK(judge_settings(before, layout, after, answer_with(3, 20)).empty());
  put(after, second, eeprom::make_copy(new_values, 2, 6));
  CHECK(judge_settings(before, layout, after, answer_with(7, 51)).empty());
  Bytes mix = old_values;
  mix[44] = 7;
  put(after, second, eeprom::make_copy(mix, 2, 6));
  CHECK(judge_settings(before, layout, after, answer_with(7, 20)) ==
        "copy 1 of the settings is neither the old ones nor the new ones");
}

TEST_CASE("a module that uses other settings than those stored is not safe", "[H-20]") {
  const Scene before = scene();
  const Bytes after = started(before);
  CHECK(judge_settings(before, layout, after, answer_with(7, 51)) ==
        "the module uses other settings than those stored");
  CHECK(judge_settings(before, layout, after, answer_with(3, 51)) ==
        "the module uses other settings than those stored");
  Answer limping = answer_with(3, 20);
  limping.limps = true;
  CHECK(judge_settings(before, layout, after, limping) == "the module reports a fault");
  CHECK(judge_settings(before, layout, after, Answer()) == "the remote was not answered as it must be");
}

TEST_CASE("a copy that stays bad, and settings that were replaced long ago, are not safe", "[H-20]") {
  Scene before = scene();
  Bytes after = started(before);
  after[second + 9] ^= 0x10;
  CHECK(judge_settings(before, layout, after, answer_with(3, 20)) ==
        "copy 1 of the settings is not whole after the start");
  before.stale = {layout.defaults};
  after = started(before);
  put(after, second, eeprom::make_copy(layout.defaults, 2, 4));
  CHECK(judge_settings(before, layout, after, answer_with(3, 20)).empty());
  put(after, second, eeprom::make_copy(layout.defaults, 2, 6));
  CHECK(judge_settings(before, layout, after, answer_with(5, 39)) ==
        "settings are in force that were replaced long ago");
}

TEST_CASE("no byte between the settings and the log may change", "[H-20]") {
  const Scene before = scene();
  for (const std::size_t at : {54U, 127U, 182U, 2047U}) {
    Bytes after = started(before);
    after[at] = 0;
    CHECK(judge_settings(before, layout, after, answer_with(3, 20)) == "a byte that is nobody's was written");
  }
}

TEST_CASE("lost settings are safe only with defaults, LIMP and an event, and unchanged", "[H-20]") {
  Scene before = scene();
  before.eeprom[10] ^= 0x01;
  before.eeprom[second + 10] ^= 0x01;
  before.settings = Scene::Settings::lost;
  Bytes after = started(before);
  const Answer limping{true, true, 8, 5, 39};
  CHECK(judge_settings(before, layout, after, limping) == "the settings are lost and the log does not say so");
  eeprom::write_record(after, {357, 25, 0, 0, 42});
  CHECK(judge_settings(before, layout, after, limping).empty());
  CHECK(judge_settings(before, layout, after, answer_with(5, 39)) ==
        "the settings are lost and the module does not limp");
  CHECK(judge_settings(before, layout, after, {true, true, 8, 3, 20}) == "the module does not use the defaults");
  put(after, 0, eeprom::make_copy(layout.defaults, 2, 6));
  CHECK(judge_settings(before, layout, after, limping) == "something was written over the settings");
}

TEST_CASE("a new board is safe without a fault and without settings", "[H-20]") {
  Scene before;
  before.eeprom = Bytes(4096, 0xFF);
  before.settings = Scene::Settings::missing;
  Bytes after = before.eeprom;
  eeprom::write_record(after, {0, 1, 0, 0, 1});
  CHECK(judge_settings(before, layout, after, answer_with(5, 39)).empty());
  CHECK(judge_log(before, after).empty());
  CHECK(judge_settings(before, layout, after, {true, true, 8, 5, 39}) == "a new board reports a fault");
}

TEST_CASE("after a cut at most one place of the log is torn, and that is the next one", "[H-20]") {
  const Scene before = scene();
  Bytes after = before.eeprom;
  CHECK(judge_log_after_cut(before, after).empty());
  after[2048 + 8 * 100] = 0xFF;
  CHECK(judge_log_after_cut(before, after).empty());
  eeprom::write_record(after, {356, 1, 0, 0, 42});
  CHECK(judge_log_after_cut(before, after).empty());
  after[2048 + 8 * 101 + 3] ^= 0x40;
  CHECK(judge_log_after_cut(before, after).empty());
  after[2048 + 8 * 102 + 3] ^= 0x40;
  CHECK(judge_log_after_cut(before, after) == "the log's place 102 is not what it was");
}

TEST_CASE("after a start the log is whole and tells of it", "[H-20][SB-3.9]") {
  const Scene before = scene();
  CHECK(judge_log(before, before.eeprom) == "the log does not tell of the start");
  Bytes after = started(before);
  CHECK(judge_log(before, after).empty());
  after[2048 + 8 * 101 + 3] ^= 0x40;
  CHECK(judge_log(before, after) == "the log's place 101 is not what it was");
  after = before.eeprom;
  eeprom::write_record(after, {356, 1, 0, 0, 41});
  CHECK(judge_log(before, after) == "the log tells of the start wrongly");
  eeprom::write_record(after, {356, 1, 1, 0, 42});
  CHECK(judge_log(before, after) == "the log tells of the start wrongly");
  after = started(before);
  eeprom::write_record(after, {357, 24, 0, 0, 42});
  CHECK(judge_log(before, after) == "the log tells of something else: event 24");
}

TEST_CASE("a copy that was never finished is not told as a bad one", "[H-20]") {
  Scene before = scene();
  Bytes after = started(before);
  eeprom::write_record(after, {357, 26, 0, 0, 42});
  CHECK(judge_log(before, after) == "the log tells of a bad copy, and there was none");
  before.may_tell_bad_copy = true;
  CHECK(judge_log(before, after).empty());
}

TEST_CASE("the first byte of a copy or a record goes first and comes back last", "[H-20]") {
  CHECK(judge_order({}).empty());
  CHECK(judge_order({{128, 0x00, 0xFF}, {131, 4, 6}, {181, 1, 2}, {128, 0xFF, 0x00}}).empty());
  CHECK(judge_order({{131, 4, 6}, {128, 0xFF, 0x00}}).empty());  // it was FF before
  CHECK(judge_order({{2849, 1, 2}, {2848, 0xFF, 1}, {2856, 8, 0xFF}, {2857, 1, 0}, {2856, 0xFF, 26}}).empty());
  CHECK_FALSE(judge_order({{131, 4, 6}, {181, 1, 2}}).empty());
  CHECK_FALSE(judge_order({{128, 0x10, 0x00}, {131, 4, 6}, {181, 1, 2}}).empty());
  CHECK_FALSE(judge_order({{128, 0x10, 0xFF}, {131, 4, 6}, {128, 0xFF, 0x00}, {181, 1, 2}}).empty());
  CHECK_FALSE(judge_order({{2848, 8, 1}, {2849, 1, 0}}).empty());
  CHECK_FALSE(judge_order({{2848, 8, 0xFF}, {2849, 1, 0}, {2848, 0xFF, 1}, {2850, 1, 0}}).empty());
}

TEST_CASE("the event log lasts longer than the chair", "[H-20]") {
  // 256 places, 50000 laps; 25 records a day: a lap in 10.24 days, 512000 days.
  CHECK(years_of_log(Usage(), 256, 2) == Approx(1401.8).margin(0.1));
  CHECK(years_of_log({0, 3, 1440}, 256, 2) == Approx(24.3).margin(0.1));  // one a minute
}

}  // namespace simulation::powercut
